// The compatibility rule of the convolution (Behar & Lien 2012, Sec. 3) over any kernel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/convolution/between.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/kernel/direction_order.hpp"
#include "reference/plane/kernel/operand.hpp"

namespace minkref::inline plane {

/// The ends that belong to a turn: [in, out), (in, out], none or both. The two sides of a
/// convolution must use the two different half-open turns: this gives the exact rule for operands
/// turned against each other by a vanishing angle, and misses nothing on the boundary
/// (docs/definitions.md, "Compatibility"). The last two values serve other readings of the paper.
enum class TurnEnds { first_included, last_included, none_included, both_included };

/// The ends that a reading includes at Q's vertices, the place of S-edges, and at P's vertices.
inline TurnEnds ends_for_s_edges(Between between) {
  if (between == Between::open) return TurnEnds::none_included;
  return between == Between::closed ? TurnEnds::both_included : TurnEnds::first_included;
}
inline TurnEnds ends_for_t_edges(Between between) {
  if (between != Between::half_open) return ends_for_s_edges(between);
  return TurnEnds::last_included;
}

namespace detail {

template <class K>
struct DirectedEdge {
  typename K::Vector direction;
  VertexId start;
};

/// All edges of an operand by angle.
template <class K>
std::vector<DirectedEdge<K>> edges_by_angle(const K& kernel,
                                            const Operand<typename K::Vector>& operand) {
  std::vector<DirectedEdge<K>> edges;
  for (std::uint32_t r = 0; r < operand.rings.size(); ++r) {
    const auto& ring = operand.rings[r];
    if (ring.size() < 2) continue;  // a point has no edges
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
      edges.push_back({typename K::Vector(ring[(i + 1) % ring.size()] - ring[i]), {r, i}});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
    return angle_less(kernel, a.direction, b.direction);
  });
  return edges;
}

/// Calls report(edge) for the edges in the ccw turn from `in` to `out`, ends as stated.
template <class K, class Report>
void edges_in_turn(const K& kernel, const std::vector<DirectedEdge<K>>& edges,
                   const typename K::Vector& in, const typename K::Vector& out, TurnEnds ends,
                   Report&& report) {
  const auto before = [&](const typename K::Vector& d) {
    return std::lower_bound(edges.begin(), edges.end(), d, [&](const auto& edge, const auto& v) {
      return angle_less(kernel, edge.direction, v);
    });
  };
  const auto behind = [&](const typename K::Vector& d) {
    return std::upper_bound(edges.begin(), edges.end(), d, [&](const auto& v, const auto& edge) {
      return angle_less(kernel, v, edge.direction);
    });
  };
  const bool with_in = ends == TurnEnds::first_included || ends == TurnEnds::both_included;
  const bool with_out = ends == TurnEnds::last_included || ends == TurnEnds::both_included;
  const auto first = with_in ? before(in) : behind(in);
  const auto last = with_out ? behind(out) : before(out);
  if (angle_less(kernel, in, out)) {
    for (auto edge = first; edge < last; ++edge) report(*edge);
  } else {  // the turn passes the angle of 180 degrees
    for (auto edge = first; edge != edges.end(); ++edge) report(*edge);
    for (auto edge = edges.begin(); edge != last; ++edge) report(*edge);
  }
}

}  // namespace detail

/// Calls report(edge start, vertex, sign) for each pair of an edge of X and a vertex of Y that the
/// rule allows: sign 1 at strictly convex vertices, -1 at reflex vertices (only if `full`), nothing
/// at straight vertices. A ring of one vertex meets every edge; the ends of a segment, given as a
/// ring of two vertices, turn by 180 degrees to the left.
template <class K, class Report>
void compatible_pairs(const K& kernel, const std::vector<detail::DirectedEdge<K>>& edges_of_x,
                      const Operand<typename K::Vector>& y, TurnEnds ends, bool full,
                      Report&& report) {
  for (std::uint32_t r = 0; r < y.rings.size(); ++r) {
    const auto& ring = y.rings[r];
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      look_for_interrupt();
      const VertexId vertex{r, i};
      if (n == 1) {
        for (const auto& edge : edges_of_x) report(edge.start, vertex, 1);
        continue;
      }
      const typename K::Vector in(ring[i] - ring[(i + n - 1) % n]);
      const typename K::Vector out(ring[(i + 1) % n] - ring[i]);
      const int turn = kernel.turn(in, out);
      const bool reversal = turn == 0 && !same_way(kernel, in, out);
      if (turn > 0 || reversal) {
        detail::edges_in_turn(kernel, edges_of_x, in, out, ends,
                              [&](const auto& edge) { report(edge.start, vertex, 1); });
      } else if (turn < 0 && full) {
        detail::edges_in_turn(kernel, edges_of_x, out, in, ends,
                              [&](const auto& edge) { report(edge.start, vertex, -1); });
      }
    }
  }
}

/// All convolution edges, S-edges first.
template <class K>
std::vector<ConvolutionEdge> convolution_edges(const K& kernel,
                                               const Operand<typename K::Vector>& P,
                                               const Operand<typename K::Vector>& Q, bool full,
                                               Between between = Between::half_open) {
  std::vector<ConvolutionEdge> result;
  const auto add = [&](ConvolutionEdge::Kind kind) {
    return [&result, kind](VertexId edge, VertexId vertex, int sign) {
      result.push_back({kind, static_cast<std::int8_t>(sign), edge, vertex});
    };
  };
  compatible_pairs(kernel, detail::edges_by_angle(kernel, P), Q, ends_for_s_edges(between), full,
                   add(ConvolutionEdge::Kind::S));
  compatible_pairs(kernel, detail::edges_by_angle(kernel, Q), P, ends_for_t_edges(between), full,
                   add(ConvolutionEdge::Kind::T));
  return result;
}

}  // namespace minkref::inline plane
