// Doubles between which a convolution edge lies at a scale.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/number/rational.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// A filter for the places of events: its bounds hold, and cover all numbers if doubles cannot
/// tell.
class EdgeBounds {
 public:
  explicit EdgeBounds(const std::vector<RationalEdge>& edges);

  /// Bounds of coordinate 0 or 1 for all points of an edge, or for its start or end alone. Requires
  /// a relative error of `scale` of at most 2^-48.
  Enclosure of_edge(std::uint32_t edge, int coordinate, double scale) const;
  Enclosure of_end(std::uint32_t edge, bool second, int coordinate, double scale) const;

 private:
  /// s p + q
  struct Number {
    double p = 0, q = 0;
    bool usable = false;  ///< each is zero or neither tiny nor huge
  };
  std::vector<std::array<std::array<Number, 2>, 2>> ends_;  ///< edge, end, coordinate
};

/// The numbers common to both enclosures.
Enclosure intersection(const Enclosure& x, const Enclosure& y);

}  // namespace minkref::inline plane
