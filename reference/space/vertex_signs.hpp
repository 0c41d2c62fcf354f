// On which side of a plane or a line vertices lie, exact and mostly without allocation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/space/box_tree.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// Vertices are named by their numbers. Signs are taken in machine words where coordinates are
/// short, else in doubles with a bound on what rounding may have done, and where this does not
/// settle it in integers.
class VertexSigns {
 public:
  /// Keeps a reference to the points.
  explicit VertexSigns(const std::vector<IntegerVector>& points);

  const std::vector<IntegerVector>& points() const { return points_; }

  /// The sign of det(b - a, c - a, d - a): 1 where d lies above the plane of a, b, c, that is, sees
  /// them counter-clockwise. Exact.
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  /// The sign of that coordinate of (b - a) x (c - a). Exact.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t axis) const;

  /// Holds the vertex, in the unit of this object.
  const SpaceBox& box(std::uint32_t vertex) const { return boxes_[vertex]; }
  /// Holds the coordinate x / over, in that unit.
  std::array<double, 2> enclosed(const Integer& x, const Integer& over = 1) const;

 private:
  const std::vector<IntegerVector>& points_;
  std::optional<std::vector<WordVector>> words_;
  long exponent_ = 0;  ///< the unit is 2^exponent_: all coordinates lie below 2^300 units
  std::vector<SpaceBox> boxes_;
  double doubt_ = 0;  ///< a difference of lower bounds is at most so far from that of coordinates
};

}  // namespace minkref::inline space
