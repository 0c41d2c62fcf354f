// All intersections of the convolution at one scale, found without events: the measure of the
// paper's update (Behar & Lien 2012, Sec. 7).
#pragma once

#include <cstddef>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/critical/line_intersection.hpp"

namespace minkref::inline plane {

/// The points where edges that are not parallel meet at a scale, ends included, by Observation 1
/// for every pair. As exact as T. Throws UndecidedSign where T cannot tell a sign. O(N^2).
template <class T>
std::vector<Vector2<T>> intersections_afresh(const std::vector<MovingEdge<Vector2<T>>>& edges,
                                             const T& scale) {
  struct Placed {
    Vector2<T> start, along;
  };
  std::vector<Placed> placed;
  placed.reserve(edges.size());
  for (const auto& edge : edges) {
    const Vector2<T> start = at(start_of(edge), scale);
    placed.push_back({start, Vector2<T>(at(end_of(edge), scale) - start)});
  }
  const T one(1);
  const auto on_edge = [&](const T& parameter) {
    return sign(parameter) >= 0 && sign(T(parameter - one)) <= 0;
  };
  std::vector<Vector2<T>> points;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    look_for_interrupt_now();
    const auto& [a0, v] = placed[i];
    for (std::size_t j = i + 1; j < placed.size(); ++j) {
      const auto& [b0, w] = placed[j];
      const T denominator = cross<T>(v, w);
      if (sign(denominator) == 0) continue;
      const Vector2<T> u(a0 - b0);
      const T r(cross<T>(w, u) / denominator);
      if (!on_edge(r) || !on_edge(T(cross<T>(v, u) / denominator))) continue;
      points.push_back(Vector2<T>(a0 + v * r));
    }
  }
  return points;
}

}  // namespace minkref::inline plane
