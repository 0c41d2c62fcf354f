// Points of the convolution with a disc: joints, and where two of its lines and circles meet.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reference/disc/convolution/arc_curves.hpp"

namespace minkref::inline disc {

/// A joint, or one of the points at which two carriers cross.
struct ArcNode {
  enum class Kind : std::uint8_t { joint, lines, line_and_circle, circles };

  Kind kind;
  std::int8_t way;  ///< which of two crossings
  /// Carriers, of a line and a circle the line first; of a joint a circle and the joint's number.
  std::uint32_t a, b;
};

/// Where two carriers meet.
struct CarrierCrossings {
  /// They touch in this point of the circles among them, in directions of coprime integers.
  struct Touch {
    Direction of_first, of_second;
  };
  std::optional<Touch> touch;
  std::vector<ArcNode> crossings;
};

/// The points of the convolution. Signs and orders are decided in intervals of doubles, and where
/// these do not tell, by roots: exact.
class ArcNodes {
 public:
  /// `curves` must outlive it.
  explicit ArcNodes(const ArcCurves& curves);

  const ArcNode& operator[](std::uint32_t k) const { return nodes_[k]; }
  std::size_t size() const { return nodes_.size(); }
  const Vector<Interval>& position(std::uint32_t k) const { return positions_[k]; }
  const RootPoint& exact(std::uint32_t k) const;

  /// Different carriers: none where they are parallel lines.
  CarrierCrossings meet(std::uint32_t a, std::uint32_t b) const;
  /// In coordinates.
  template <class N>
  Vector<N> place(const ArcNode& node) const;

  std::uint32_t add(const ArcNode& node, const Vector<Interval>& position);
  /// The point of a circle in a direction of coprime integers.
  std::uint32_t joint(std::uint32_t circle, const Direction& normal);

  /// Whether both are one point: whether the one is on both carriers of the other.
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
