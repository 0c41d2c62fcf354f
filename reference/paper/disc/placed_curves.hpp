// The convolution's curves at a scale, cut at listed intersections, in any arithmetic.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/paper/disc/curve_frame.hpp"
#include "reference/paper/disc/meeting.hpp"

namespace minkref::inline disc {

/// A piece between two nodes, with all features along the piece; the first runs from `from`.
struct CutCurve {
  struct Cover {
    std::uint32_t feature;
    bool along;
  };
  std::uint32_t from, to;
  int quadrant;  ///< -1 if straight
  std::vector<Cover> covers;
};

/// Nodes with their places, and pieces. As exact as T. A listed intersection beyond a curve's end,
/// through rounding, counts as the end.
template <class T>
class PlacedCurves {
 public:
  PlacedCurves(const CurveFrame& frame, const std::vector<MovingFeature<T>>& features,
               const DiscScale<T>& at)
      : frame_(frame), features_(features), at_(at), cuts_(frame.parts.size()) {
    for (const FrameNode& node : frame.nodes) add_node(place_of(node), 0);
  }

  /// Adds a point that two features share, with its place.
  void meet(std::uint32_t a, std::uint32_t b, const Vector<T>& x) {
    const Found on_a = locate(a, x), on_b = locate(b, x);
    std::uint32_t node = on_a.end != none ? on_a.end : on_b.end;
    if (node == none) {
      node = add_node(x, features_[a].is_arc || features_[b].is_arc ? 2 : 1);
    } else if (on_a.end != none && on_b.end != none) {
      join(on_a.end, on_b.end);
    }
    if (on_a.end == none) cuts_[on_a.part].push_back(node);
    if (on_b.end == none) cuts_[on_b.part].push_back(node);
  }

  /// Cuts two facing segments on one line at each other's ends.
  void overlap(std::uint32_t a, std::uint32_t b) {
    for (const auto& [own, other] : {std::pair{a, b}, std::pair{b, a}}) {
      for (const std::uint32_t end : frame_.ends[other]) {
        const Found found = locate(own, places_[end]);
        if (found.end == none) cuts_[found.part].push_back(end);
      }
    }
  }

  /// Joins nodes at equal places, and cuts the curves at nodes. O(k log k) for k cuts.
  void finish() {
    join_equal();
    for (std::uint32_t part = 0; part < frame_.parts.size(); ++part) {
      look_for_interrupt();
      cut(part);
    }
  }

  const CurveFrame& frame() const { return frame_; }
  const MovingFeature<T>& feature(std::uint32_t k) const { return features_[k]; }
  const DiscScale<T>& at() const { return at_; }
  const std::vector<CutCurve>& curves() const { return curves_; }
  std::size_t nodes() const { return places_.size(); }
  const Vector<T>& place(std::uint32_t node) const { return places_[node]; }
  /// The representative node at the same place.
  std::uint32_t root(std::uint32_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  /// A part, and the part's end node if the place is at an end.
  struct Found {
    std::uint32_t part, end;
  };

  Vector<T> place_of(const FrameNode& node) const {
    const MovingFeature<T>& own = features_[node.feature];
    if (node.end >= 0) return own.end(static_cast<std::size_t>(node.end), at_);
    const T radius(at_.s * at_.r);
    const auto part = [&](const Rational& x) { return T(T(x.sign()) * radius); };
    return own.centre() + Vector<T>{part(node.axis.x), part(node.axis.y)};
  }

  std::uint32_t add_node(const Vector<T>& x, int rank) {
    places_.push_back(x);
    ranks_.push_back(rank);
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }

  /// Keeps the place with fewer roots.
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (std::tuple(ranks_[b], b) < std::tuple(ranks_[a], a)) std::swap(a, b);
    parent_[b] = a;
  }

  /// How far along a part a place is.
  T key(const CurvePart& part, const Vector<T>& x) const {
    const MovingFeature<T>& own = features_[part.feature];
    const Vector<T> y = x - own.corner[0];
    switch (part.quadrant) {
      case -1:
        return dot(own.along, y);
      case 0:
        return T(y.y - y.x);
      case 1:
        return T(T(-y.x) - y.y);
      case 2:
        return T(y.x - y.y);
      default:
        return T(y.x + y.y);
    }
  }

  Found locate(std::uint32_t feature, const Vector<T>& x) const {
    std::uint32_t part = frame_.first_part[feature];
    const std::uint32_t last = frame_.first_part[feature + 1];
    if (features_[feature].is_arc) {
      const Vector<T> y = x - features_[feature].centre();
      const int of_x = sign(y.x), of_y = sign(y.y);
      const auto holds = [&](int quadrant) {
        return (quadrant == 0 || quadrant == 3 ? of_x >= 0 : of_x <= 0) &&
               (quadrant <= 1 ? of_y >= 0 : of_y <= 0);
      };
      while (part < last && !holds(frame_.parts[part].quadrant)) ++part;
      if (part == last) {  // only as rounded
        const auto& way = features_[feature].way;
        const bool is_behind = sign(T(T(dot(way[1], y)) - T(dot(way[0], y)))) > 0;
        part = is_behind ? last - 1 : frame_.first_part[feature];
        return {part, is_behind ? frame_.parts[part].to : frame_.parts[part].from};
      }
    }
    const CurvePart& own = frame_.parts[part];
    const T here = key(own, x);
    if (order_of(here, key(own, places_[own.from])) <= 0) return {part, own.from};
    if (order_of(here, key(own, places_[own.to])) >= 0) return {part, own.to};
    return {part, none};
  }

  void join_equal() {
    std::vector<std::uint32_t> order(places_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      look_for_interrupt();
      const int of_x = order_of(places_[a].x, places_[b].x);
      return of_x != 0 ? of_x < 0 : order_of(places_[a].y, places_[b].y) < 0;
    });
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (detail::are_equal(places_[order[k - 1]], places_[order[k]])) {
        join(order[k - 1], order[k]);
      }
    }
  }

  void cut(std::uint32_t number) {
    const CurvePart& part = frame_.parts[number];
    std::vector<std::pair<T, std::uint32_t>> inner;
    for (const std::uint32_t node : cuts_[number]) {
      inner.emplace_back(key(part, places_[root(node)]), node);
    }
    std::sort(inner.begin(), inner.end(),
              [](const auto& x, const auto& y) { return order_of(x.first, y.first) < 0; });
    std::uint32_t from = root(part.from);
    for (const auto& [place, node] : inner) from = add_curve(part, from, root(node));
    add_curve(part, from, root(part.to));
  }

  std::uint32_t add_curve(const CurvePart& part, std::uint32_t from, std::uint32_t to) {
    if (from == to) return to;
    const std::uint32_t carrier = part.quadrant < 0 ? none : part.feature;
    const auto [found, is_new] =
        known_.try_emplace({std::min(from, to), std::max(from, to), carrier}, curves_.size());
    if (is_new) curves_.push_back({from, to, part.quadrant, {}});
    CutCurve& curve = curves_[found->second];
    curve.covers.push_back({part.feature, curve.from == from});
    return to;
  }

  const CurveFrame& frame_;
  const std::vector<MovingFeature<T>>& features_;
  const DiscScale<T>& at_;
  std::vector<Vector<T>> places_;
  std::vector<int> ranks_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::vector<std::uint32_t>> cuts_;
  std::vector<CutCurve> curves_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::size_t> known_;
};

}  // namespace minkref::inline disc
