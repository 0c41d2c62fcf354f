// An arrangement within one facet: cells between the traces.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reference/paper/space/placed_facets.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/arrangement/interior_point.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline space {

/// A facet's border and traces, seen along the normal's longest axis. As exact as T.
template <class T>
class FacetCells {
 public:
  using Vector = typename PlacedFacets<T>::Vector;
  using K = PlainKernel<T>;

  /// `placed` must outlive it. O((n + k) log n) for n nodes and k crossings of traces.
  FacetCells(const PlacedFacets<T>& placed, std::uint32_t facet)
      : placed_(placed),
        facet_(facet),
        normal_(placed.normal(facet)),
        axis_(longest(normal_)),
        points_(local_points()),
        arrangement_(kernel_, std::move(points_), std::move(segments_)) {}
  FacetCells(const FacetCells&) = delete;
  FacetCells& operator=(const FacetCells&) = delete;

  std::size_t node_count() const { return arrangement_.node_count(); }
  /// Cells: faces from 1 on, within the facet.
  std::size_t face_count() const { return arrangement_.face_count(); }
  const Arrangement<K>& arrangement() const { return arrangement_; }
  const Vector& normal() const { return normal_; }
  /// The axis that the view drops; the other coordinates keep their order.
  std::size_t axis() const { return axis_; }

  /// A face's inner point, in space: beside the longest edge, as far as doubles tell. Nothing if
  /// rounding left no edge with a length.
  std::optional<Vector> inner_point(std::uint32_t face) const {
    double longest = 0;
    std::uint32_t edge = Arrangement<K>::none;
    arrangement_.for_each_half_edge(face, [&](std::uint32_t h) {
      const Vector2<T> along = position(arrangement_.target(h)) - position(arrangement_.origin(h));
      const double length = std::hypot(approximate(along.x()), approximate(along.y()));
      if (edge != Arrangement<K>::none && !(length > longest)) return;
      longest = length;
      edge = h;
    });
    const Vector2<T> along =
        position(arrangement_.target(edge)) - position(arrangement_.origin(edge));
    if (sign(along.x()) == 0 && sign(along.y()) == 0) return std::nullopt;
    return lifted(plane::detail::middle_of_face<T, Vector2<T>>(
        arrangement_, face, edge, [&](std::uint32_t n) { return position(n); }));
  }

  /// Lifts a point from the view onto the facet.
  Vector lifted(const Vector2<T>& seen) const {
    const Vector& a = placed_.corner(facet_, 0);
    const Vector2<T> from = this->seen(a);
    const auto [u, v] = axes();
    Vector x;
    x[u] = seen.x();
    x[v] = seen.y();
    const auto w = static_cast<Eigen::Index>(axis_);
    x[w] = a[w] - T(normal_[u] * T(seen.x() - from.x()) + normal_[v] * T(seen.y() - from.y())) /
                      normal_[w];
    return x;
  }

  /// Whether the face borders on the inside of a crossing facet, from below. Then the sum, which
  /// lies below each facet, holds the face inside.
  bool is_below_another(std::uint32_t face) const {
    bool below = false;
    arrangement_.for_each_half_edge(face, [&](std::uint32_t h) {
      for (auto cover = arrangement_.covers_begin(h); cover != arrangement_.covers_end(h);
           ++cover) {
        const int left = above_on_left_[cover->segment];
        below = below || (arrangement_.runs_with(h, *cover) ? left < 0 : left > 0);
      }
    });
    return below;
  }

 private:
  static std::size_t longest(const Vector& n) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(approximate(n[static_cast<Eigen::Index>(k)])) >
          std::abs(approximate(n[static_cast<Eigen::Index>(axis)]))) {
        axis = k;
      }
    }
    return axis;
  }

  std::pair<Eigen::Index, Eigen::Index> axes() const {
    return {axis_ == 0 ? 1 : 0, axis_ == 2 ? 1 : 2};
  }
  Vector2<T> seen(const Vector& x) const {
    const auto [u, v] = axes();
    return {x[u], x[v]};
  }

  std::uint32_t local(std::uint32_t node) {
    const auto [found, fresh] = local_.try_emplace(node, static_cast<std::uint32_t>(local_.size()));
    if (fresh) nodes_.push_back(node);
    return found->second;
  }

  std::vector<Vector2<T>> local_points() {
    const std::vector<std::uint32_t> border = placed_.border(facet_);
    for (std::size_t k = 0; k < border.size(); ++k) {
      segments_.push_back({local(border[k]), local(border[(k + 1) % border.size()])});
    }
    above_on_left_.assign(segments_.size(), 0);
    for (const Trace& trace : placed_.traces[facet_]) {
      segments_.push_back({local(trace.from), local(trace.to)});
      above_on_left_.push_back(trace.other == FacetNames::none ? 0 : above_on_left(trace));
    }
    std::vector<Vector2<T>> points;
    points.reserve(nodes_.size());
    for (const std::uint32_t node : nodes_) points.push_back(seen(placed_.points[node]));
    return points;
  }

  /// 1 if the left of the trace, in the view, is above the facet that crosses, -1 if below; 0 if
  /// the trace may lie on that facet's border.
  int above_on_left(const Trace& trace) const {
    bool above = false, below = false;
    for (std::size_t k = 0; k < placed_.size(trace.other); ++k) {
      const Vector way = placed_.corner(trace.other, k) - placed_.corner(facet_, 0);
      const int side = sign(T(normal_.dot(way)));
      above = above || side > 0;
      below = below || side < 0;
    }
    if (!above || !below) return 0;
    const Vector along = placed_.points[trace.to] - placed_.points[trace.from];
    const int left = sign(T(placed_.normal(trace.other).dot(normal_.cross(along))));
    return is_mirrored() ? -left : left;
  }

  const Vector2<T>& position(std::uint32_t node) const { return arrangement_.node(node); }

  /// Whether counter-clockwise about the normal is clockwise in the view.
  bool is_mirrored() const {
    return (sign(normal_[static_cast<Eigen::Index>(axis_)]) > 0) == (axis_ == 1);
  }

  const PlacedFacets<T>& placed_;
  const std::uint32_t facet_;
  const K kernel_;
  const Vector normal_;
  const std::size_t axis_;
  std::unordered_map<std::uint32_t, std::uint32_t> local_;
  std::vector<std::uint32_t> nodes_;  ///< by local number
  std::vector<IndexedSegment> segments_;
  std::vector<int> above_on_left_;  ///< by segment
  std::vector<Vector2<T>> points_;
  const Arrangement<K> arrangement_;
};

}  // namespace minkref::inline space
