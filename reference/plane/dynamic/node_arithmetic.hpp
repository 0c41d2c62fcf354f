// Exact comparisons of nodes along an edge, with arithmetic that fits the operands.
#pragma once

#include <memory>
#include <vector>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/kernel/fraction.hpp"

namespace minkref::inline plane {

/// How another edge crosses an edge: `turn` is 1 from right to left, -1 from left to right. An edge
/// that starts or ends on the line of the first at every scale has no part on one side.
struct EdgeCrossing {
  int turn = 0;
  bool starts_here = false, ends_here = false;
};

/// Nodes have their names from the table; start_of_edge and end_of_edge (edge_history.hpp) name the
/// edge's own ends. All answers are exact.
class NodeArithmetic {
 public:
  virtual ~NodeArithmetic() = default;
  /// PositionAlong's slope and value, each rounded once, for all nodes of an edge as the table
  /// orders them.
  virtual void columns(std::uint32_t edge, std::vector<double>& slope,
                       std::vector<double>& value) const = 0;
  /// A group's scale.
  virtual Fraction scale(std::uint32_t group) const = 0;
  /// The sign of the difference between two positions at a scale.
  virtual int compare(std::uint32_t edge, std::uint32_t x, std::uint32_t y,
                      const Fraction& scale) const = 0;
  /// The sign of the difference between two slopes.
  virtual int compare_slopes(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const = 0;
  /// Whether two nodes coincide at every scale.
  virtual bool same_track(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const = 0;
  /// At a node where another edge crosses.
  virtual EdgeCrossing crossing(std::uint32_t edge, std::uint32_t node) const = 0;
};

std::unique_ptr<NodeArithmetic> node_arithmetic(const PolygonSet& P, const PolygonSet& Q,
                                                const ArrangementEvents& events);

}  // namespace minkref::inline plane
