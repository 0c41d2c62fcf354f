// Faces in the sum, found by orientable loops, nesting and collision detection (Behar & Lien 2012,
// Sec. 3).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/paper/disc/curve_rays.hpp"
#include "reference/paper/disc/disc_collision.hpp"

namespace minkref::inline disc {

template <class T>
class CurveFaces {
 public:
  /// `is_connected`: whether P has a single component; then a face with a second cycle belongs to
  /// the sum. O(n log n) for each connected part and for each collision test.
  CurveFaces(const CurveCycles<T>& cycles, const std::vector<MovingFeature<T>>& features,
             bool is_connected, const Arithmetic<T>& in)
      : cycles_(cycles),
        features_(features),
        is_connected_(is_connected),
        rays_(cycles, in),
        joined_(cycles.cycles() + 1) {
    nest();
    decide();
  }

  bool is_inside(std::uint32_t half_edge) const { return inside_[face(half_edge)]; }
  /// The left face's number.
  std::uint32_t face(std::uint32_t half_edge) const { return faces_[cycles_.cycle(half_edge)]; }
  std::size_t count() const { return of_face_.size(); }
  std::size_t asked() const { return asked_; }

 private:
  /// Relates cycles along a ray through each connected part.
  void nest() {
    const std::vector<CutCurve>& curves = cycles_.placed().curves();
    DisjointSets parts(cycles_.placed().nodes());
    for (const CutCurve& curve : curves) parts.join(curve.from, curve.to);
    std::vector<bool> is_done(cycles_.placed().nodes(), false);
    for (std::uint32_t k = 0; k < curves.size(); ++k) {
      look_for_interrupt();
      const std::uint32_t part = parts.root(curves[k].from);
      if (is_done[part]) continue;
      const auto ray = rays_.through(k);
      if (!ray) continue;
      is_done[part] = true;
      std::uint32_t left = cycles_.cycles();  // the outside
      for (const auto& hit : ray->hits) {
        joined_.join(cycles_.cycle(hit.rising), left);
        left = cycles_.cycle(hit.rising ^ 1U);
      }
      joined_.join(left, cycles_.cycles());
    }
  }

  void decide() {
    const std::uint32_t count = cycles_.cycles();
    std::vector<std::uint32_t> number(count + 1, UINT32_MAX);
    const auto face_of = [&](std::uint32_t cycle) {
      std::uint32_t& own = number[joined_.root(cycle)];
      if (own == UINT32_MAX) {
        own = static_cast<std::uint32_t>(of_face_.size());
        of_face_.emplace_back();
      }
      return own;
    };
    face_of(count);  // the outside is face 0
    for (std::uint32_t cycle = 0; cycle < count; ++cycle) {
      faces_.push_back(face_of(cycle));
      of_face_[faces_.back()].push_back(cycle);
    }
    inside_.push_back(false);
    for (std::uint32_t face = 1; face < of_face_.size(); ++face) {
      look_for_interrupt_now();
      inside_.push_back(is_in_sum(face));
    }
  }

  bool is_in_sum(std::uint32_t face) {
    if (is_connected_ && of_face_[face].size() > 1) return true;
    if (!is_orientable(face)) return true;
    ++asked_;
    return collides(face);
  }

  /// Whether every curve about a face runs against it: the sum is on the left of each.
  bool is_orientable(std::uint32_t face) const {
    bool result = true;
    for (const std::uint32_t cycle : of_face_[face]) {
      cycles_.for_each_half_edge(cycle, [&](std::uint32_t h) {
        for (const CutCurve::Cover& cover : cycles_.curve(h).covers) {
          result = result && !CurveCycles<T>::runs_with(h, cover);
        }
      });
    }
    return result;
  }

  bool collides(std::uint32_t face) const {
    std::vector<std::pair<double, std::uint32_t>> by_height;
    for (const std::uint32_t cycle : of_face_[face]) {
      cycles_.for_each_half_edge(cycle, [&](std::uint32_t h) {
        const auto y = [&](std::uint32_t half_edge) {
          return approximate(cycles_.placed().place(cycles_.source(half_edge)).y);
        };
        by_height.emplace_back(-std::abs(y(h) - y(h ^ 1U)), h);
      });
    }
    std::sort(by_height.begin(), by_height.end());
    for (const auto& [height, h] : by_height) {
      const auto ray = rays_.through(h / 2);
      if (!ray) continue;
      const auto& hits = ray->hits;
      for (std::size_t k = 0; k < hits.size(); ++k) {
        if (hits[k].rising / 2 != h / 2) continue;
        const std::size_t right = hits[k].rising == h ? k : k + 1;
        if (right == 0 || right == hits.size()) return false;  // no face, as rounded
        if (const auto x = rays_.between(hits[right - 1].x, hits[right].x)) {
          return meets_disc(features_, square(), Vector<T>{*x, ray->y});
        }
      }
    }
    return true;  // too small for the arithmetic to have a point in it
  }

  T square() const {
    const T radius(cycles_.placed().at().s * cycles_.placed().at().r);
    return T(radius * radius);
  }

  const CurveCycles<T>& cycles_;
  const std::vector<MovingFeature<T>>& features_;
  bool is_connected_;
  CurveRays<T> rays_;
  DisjointSets joined_;
  std::vector<std::uint32_t> faces_;                 ///< by cycle
  std::vector<std::vector<std::uint32_t>> of_face_;  ///< its cycles
  std::vector<bool> inside_;
  std::size_t asked_ = 0;
};

}  // namespace minkref::inline disc
