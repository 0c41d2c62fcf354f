// Exact comparisons of nodes along an edge, in the arithmetic that fits the operands.
#pragma once

#include <memory>
#include <vector>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/kernel/fraction.hpp"

namespace minkref::inline plane {

/// Nodes are named as in the table; start_of_edge and end_of_edge (edge_history.hpp) name the ends
/// of the edge itself. All answers are exact.
class NodeArithmetic {
 public:
  virtual ~NodeArithmetic() = default;
  /// slope s + value of PositionAlong, each rounded once: of all nodes of an edge, in the order of
  /// the table.
  virtual void columns(std::uint32_t edge, std::vector<double>& slope,
                       std::vector<double>& value) const = 0;
  /// The scale of a group.
  virtual Fraction scale(std::uint32_t group) const = 0;
  /// The sign of the difference of two positions at a scale.
  virtual int compare(std::uint32_t edge, std::uint32_t x, std::uint32_t y,
                      const Fraction& scale) const = 0;
  /// The sign of the difference of their slopes.
  virtual int compare_slopes(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const = 0;
  /// Whether they are one point at every scale.
  virtual bool same_track(std::uint32_t edge, std::uint32_t x, std::uint32_t y) const = 0;
};

std::unique_ptr<NodeArithmetic> node_arithmetic(const PolygonSet& P, const PolygonSet& Q,
                                                const ArrangementEvents& events);

}  // namespace minkref::inline plane
