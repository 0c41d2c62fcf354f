// The swept convolution edge's nodes: names, positions, order.
#pragma once

#include <memory>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/dynamic/node_arithmetic.hpp"

namespace minkref::inline plane {

/// Holds one edge at a time. Its nodes have local numbers from 0; the next two numbers mean its
/// start and its end. Comparisons are exact: doubles decide if they can tell.
class SweptEdge {
 public:
  SweptEdge(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events);

  void load(std::uint32_t edge);

  std::uint32_t edge() const { return edge_; }
  const RationalEdge& moving() const { return events_.moving()[edge_]; }
  std::uint32_t count() const { return count_; }
  std::uint32_t start() const { return count_; }
  std::uint32_t end() const { return count_ + 1; }
  /// A local node's name within an EdgeHistory.
  std::uint32_t name(std::uint32_t local) const {
    return local == start() ? start_of_edge : local == end() ? end_of_edge : begin_ + local;
  }
  const EdgeNode& node(std::uint32_t local) const { return events_.table().nodes[begin_ + local]; }

  /// The position along the edge, slope s + value, as doubles.
  double slope(std::uint32_t local) const { return slope_[local]; }
  double value(std::uint32_t local) const { return value_[local]; }
  double near(std::uint32_t local, double s) const { return slope_[local] * s + value_[local]; }
  /// Sums the absolute terms of `near`, to bound its rounding.
  double terms(std::uint32_t local, double s) const {
    return std::abs(slope_[local]) * s + std::abs(value_[local]);
  }
  Rational along(std::uint32_t local, const Rational& scale) const;
  /// The point half-way between two nodes.
  Point middle(std::uint32_t x, std::uint32_t y, const Rational& scale) const;

  /// How a crossing node's second edge runs.
  EdgeCrossing crossing(std::uint32_t local) const {
    return arithmetic_->crossing(edge_, name(local));
  }

  /// The sign of x's position less y's, at a group's scale.
  int compare_at_group(std::uint32_t x, std::uint32_t y, std::uint32_t group);
  int compare_at(std::uint32_t x, std::uint32_t y, const Rational& scale, double near_scale) const;
  /// Whether x comes before y just above a scale at which both coincide.
  bool before_after_meeting(std::uint32_t x, std::uint32_t y) const;
  /// Whether both coincide at every scale.
  bool same_track(std::uint32_t x, std::uint32_t y) const;

 private:
  int compare_in_doubles(std::uint32_t x, std::uint32_t y, double s) const;
  int compare_slopes(std::uint32_t x, std::uint32_t y) const;
  PositionAlong<Rational> position(std::uint32_t local) const;

  const ArrangementEvents& events_;
  std::unique_ptr<NodeArithmetic> arithmetic_;
  std::uint32_t edge_ = 0, begin_ = 0, count_ = 0;
  std::vector<double> slope_, value_;
  std::uint32_t exact_group_ = EdgeNode::always;  ///< whose scale is exact_scale_
  Fraction exact_scale_;
};

}  // namespace minkref::inline plane
