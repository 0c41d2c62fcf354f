// Points of the convolution with a disc: joints, and crossings between lines and circles.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reference/disc/convolution/arc_curves.hpp"

namespace minkref::inline disc {

/// A joint, or a point where two carriers cross.
struct ArcNode {
  enum class Kind : std::uint8_t { joint, lines, line_and_circle, circles };

  Kind kind;
  std::int8_t way;  ///< which of two crossings
  /// Carriers, of a line and a circle the line first; of a joint a circle and the joint's number.
  std::uint32_t a, b;
};

/// Where two carriers meet.
struct CarrierCrossings {
  /// The touching point on each circle among the carriers, as a direction with coprime integers.
  struct Touch {
    Direction of_first, of_second;
  };
  std::optional<Touch> touch;
  std::vector<ArcNode> crossings;
};

/// The points of the convolution. Intervals of doubles decide signs and orders or, if intervals do
/// not tell, roots: exact.
class ArcNodes {
 public:
  /// `curves` must outlive it.
  explicit ArcNodes(const ArcCurves& curves);

  const ArcNode& operator[](std::uint32_t k) const { return nodes_[k]; }
  std::size_t size() const { return nodes_.size(); }
  const Vector<Interval>& position(std::uint32_t k) const { return positions_[k]; }
  const RootPoint& exact(std::uint32_t k) const;

  /// Intersects different carriers: parallel lines have no common point.
  CarrierCrossings meet(std::uint32_t a, std::uint32_t b) const;
  /// In coordinates.
  template <class N>
  Vector<N> place(const ArcNode& node) const;

  std::uint32_t add(const ArcNode& node, const Vector<Interval>& position);
  /// The node at a circle's point along a direction with coprime integers.
  std::uint32_t joint(std::uint32_t circle, const Direction& normal);

  /// Whether both nodes coincide: whether one node lies on both of the other's carriers.
  bool are_same(std::uint32_t a, std::uint32_t b) const;

 private:
  bool is_on(const RootPoint& x, std::uint32_t carrier) const;
  bool is_at(const RootPoint& x, const ArcNode& node) const;
  CarrierCrossings meet_lines(std::uint32_t a, std::uint32_t b) const;
  CarrierCrossings meet_line_and_circle(std::uint32_t line, std::uint32_t circle) const;
  CarrierCrossings meet_circles(std::uint32_t a, std::uint32_t b) const;
  template <class N>
  Vector<N> place_of_joint(const ArcJoint& joint) const;
  template <class N>
  Vector<N> place_of_lines(const ArcCarrier& a, const ArcCarrier& b) const;
  template <class N>
  Vector<N> place_on_line(const ArcCarrier& line, const ArcCarrier& circle, int way) const;
  template <class N>
  Vector<N> place_of_circles(const ArcCarrier& a, const ArcCarrier& b, int way) const;

  const ArcCurves& curves_;
  std::vector<ArcJoint> joints_;
  std::map<std::pair<std::uint32_t, std::pair<Rational, Rational>>, std::uint32_t> joint_nodes_;
  std::vector<ArcNode> nodes_;
  std::vector<Vector<Interval>> positions_;
  mutable std::map<std::uint32_t, RootPoint> exact_;
};

}  // namespace minkref::inline disc
