// The boundary of the faces in the sum, as rings of curves (docs/disc.md, "Canonical form").
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "reference/paper/disc/curve_faces.hpp"
#include "reference/paper/disc/disc_answer.hpp"

namespace minkref::inline disc {

template <class T>
class AnswerRings {
 public:
  AnswerRings(const CurveCycles<T>& cycles, const CurveFaces<T>& faces)
      : cycles_(cycles), faces_(faces), placed_(cycles.placed()), joined_(faces.count()) {}

  /// O(k log k) for k pieces.
  DiscAnswer answer() {
    DiscAnswer result;
    result.nodes = placed_.nodes();
    result.faces = faces_.count();
    result.asked = faces_.asked();
    for (std::uint32_t h = 0; h < cycles_.half_edges(); h += 2) {
      if (faces_.is_inside(h) == faces_.is_inside(h ^ 1U)) {
        joined_.join(faces_.face(h), faces_.face(h ^ 1U));
      }
    }
    find_rings();
    std::map<std::uint32_t, FormComponent> of_root;
    std::map<std::uint32_t, std::vector<FormRing>> outer;
    for (std::uint32_t k = 0; k < rings_.size(); ++k) {
      const std::uint32_t root = joined_.root(faces_.face(rings_[k][0]));
      FormRing ring{curves_of(rings_[k]), k};
      result.rings.push_back(pieces_of(rings_[k]));
      FormComponent& component = of_root[root];
      if (is_hole(rings_[k])) {
        component.holes.push_back(std::move(ring));
      } else {
        outer[root].push_back(std::move(ring));
      }
    }
    for (auto& [root, component] : of_root) add_component(component, outer[root], result.form);
    result.components = result.form.size();
    result.holes = outside_parts() - 1;
    make_canonical(result.form, placed_.frame().curves);
    return result;
  }

 private:
  bool is_boundary(std::uint32_t h) const {
    return faces_.is_inside(h) && !faces_.is_inside(h ^ 1U);
  }

  /// The parts of the complement, the unbounded one included.
  std::size_t outside_parts() {
    std::set<std::uint32_t> roots{joined_.root(0)};
    for (std::uint32_t h = 0; h < cycles_.half_edges(); ++h) {
      if (!faces_.is_inside(h)) roots.insert(joined_.root(faces_.face(h)));
    }
    return roots.size();
  }

  /// Only rounding gives a component none or several outer rings.
  static void add_component(FormComponent& component, std::vector<FormRing>& outer,
                            OffsetForm& form) {
    if (outer.empty()) {
      outer.push_back(std::move(component.holes.back()));
      component.holes.pop_back();
    }
    component.outer = std::move(outer[0]);
    form.push_back(std::move(component));
    for (std::size_t k = 1; k < outer.size(); ++k) form.push_back({std::move(outer[k]), {}});
  }

  /// Walks round the interior's wedges, and splits where a walk comes to a node again.
  void find_rings() {
    std::vector<bool> is_done(cycles_.half_edges(), false);
    for (std::uint32_t first = 0; first < cycles_.half_edges(); ++first) {
      if (is_done[first] || !is_boundary(first)) continue;
      look_for_interrupt();
      std::vector<std::uint32_t> open, places;
      std::map<std::uint32_t, std::size_t> opened;
      for (std::uint32_t h = first; !is_done[h]; h = after(h)) {
        is_done[h] = true;
        const std::uint32_t node = cycles_.source(h);
        const auto found = opened.find(node);
        if (found != opened.end()) {
          const auto from = open.begin() + static_cast<std::ptrdiff_t>(found->second);
          rings_.emplace_back(from, open.end());
          open.erase(from, open.end());
          for (; places.back() != node; places.pop_back()) opened.erase(places.back());
        } else {
          opened[node] = open.size();
          places.push_back(node);
        }
        open.push_back(h);
      }
      rings_.push_back(std::move(open));
    }
  }

  std::uint32_t after(std::uint32_t half_edge) const {
    std::uint32_t h = cycles_.next(half_edge);
    while (!is_boundary(h)) h = cycles_.clockwise(h);
    return h;
  }

  /// The feature that runs as a half-edge of the boundary does.
  std::uint32_t feature(std::uint32_t h) const {
    const auto& covers = cycles_.curve(h).covers;
    for (const CutCurve::Cover& cover : covers) {
      if (CurveCycles<T>::runs_with(h, cover)) return cover.feature;
    }
    return covers[0].feature;
  }

  /// Whether a half-edge goes on smoothly into another: along the same curve, or the next one.
  bool goes_on(std::uint32_t h, std::uint32_t following) const {
    const std::uint32_t a = feature(h), b = feature(following);
    if (a == b) return true;
    const auto& ends = placed_.frame().ends;
    const std::uint32_t node = cycles_.source(following);
    return placed_.root(ends[a][1]) == node && placed_.root(ends[b][0]) == node &&
           ends[a][1] == ends[b][0];
  }

  std::uint32_t curve_of(std::uint32_t h) const {
    return placed_.frame().features[feature(h)].curve;
  }

  std::vector<std::uint32_t> curves_of(const std::vector<std::uint32_t>& ring) const {
    std::vector<std::uint32_t> found;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t before = ring[(k + ring.size() - 1) % ring.size()];
      if (curve_of(before) == curve_of(ring[k]) && goes_on(before, ring[k])) continue;
      found.push_back(curve_of(ring[k]));
    }
    if (found.empty()) found.push_back(curve_of(ring[0]));
    return found;
  }

  /// Arcs turn left, corners turn right: at the leftmost place the sum lies on the right if the
  /// ring is smooth there, else the complement.
  bool is_hole(const std::vector<std::uint32_t>& ring) const {
    const T* smooth = nullptr;
    const T* corner = nullptr;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t before = ring[(k + ring.size() - 1) % ring.size()];
      const T*& least = goes_on(before, ring[k]) ? smooth : corner;
      const T& x = placed_.place(cycles_.source(ring[k])).x;
      if (least == nullptr || order_of(x, *least) < 0) least = &x;
    }
    return corner != nullptr && (smooth == nullptr || order_of(*corner, *smooth) <= 0);
  }

  std::vector<DiscAnswer::Piece> pieces_of(const std::vector<std::uint32_t>& ring) const {
    std::vector<DiscAnswer::Piece> found;
    for (const std::uint32_t h : ring) {
      const MovingFeature<T>& own = placed_.feature(feature(h));
      const Vector<T>&from = placed_.place(cycles_.source(h)),
            &to = placed_.place(cycles_.source(h ^ 1U));
      found.push_back({own.is_arc, approximate(own.corner[0].x), approximate(own.corner[0].y),
                       approximate(from.x), approximate(from.y), approximate(to.x),
                       approximate(to.y)});
    }
    return found;
  }

  const CurveCycles<T>& cycles_;
  const CurveFaces<T>& faces_;
  const PlacedCurves<T>& placed_;
  DisjointSets joined_;
  std::vector<std::vector<std::uint32_t>> rings_;
};

}  // namespace minkref::inline disc
