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

/// Numbers name the vertices. Machine words decide signs for short coordinates, else doubles with a
/// bound on rounding errors, and integers if doubles do not settle a sign.
class VertexSigns {
 public:
  /// Keeps a reference to the points.
  explicit VertexSigns(const std::vector<IntegerVector>& points);

  const std::vector<IntegerVector>& points() const { return points_; }

  /// The sign of det(b - a, c - a, d - a): 1 if d lies above the plane through a, b, c, that is,
  /// sees them counter-clockwise. Exact.
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  /// The sign of (b - a) x (c - a) along `axis`. Exact.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t axis) const;

  /// A box around the vertex, measured with this object's unit.
  const SpaceBox& box(std::uint32_t vertex) const { return boxes_[vertex]; }
  /// Bounds for the coordinate x / over, measured with this object's unit.
  std::array<double, 2> enclosed(const Integer& x, const Integer& over = 1) const;

 private:
  const std::vector<IntegerVector>& points_;
  std::optional<std::vector<WordVector>> words_;
  long exponent_ = 0;  ///< the unit is 2^exponent_: all coordinates lie below 2^300 units
  std::vector<SpaceBox> boxes_;
  double doubt_ = 0;  ///< a difference of lower bounds is at most so far from that of coordinates
};

}  // namespace minkref::inline space
