// An operand as triangles over integers: what the convolution and the collision test look at.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reference/space/box_tree.hpp"
#include "reference/space/edges/vectors.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

inline constexpr std::uint32_t none = UINT32_MAX;

/// A solid, a plane polygon (one face: a solid without thickness, with faces on both sides), a
/// segment or a point. Cutting faces into triangles adds flat edges, which play no part in the
/// convolution.
struct SpaceOperand {
  struct Triangle {
    std::array<std::uint32_t, 3> corners;  ///< counter-clockwise seen from outside
    std::array<std::uint32_t, 3> edges;    ///< from each corner to the next
    FilteredVector normal;                 ///< twice the vector area
  };
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t left, right;  ///< triangles; none for a segment
    bool convex;  ///< the solid angle is less than a half-space; so is the edge of a segment
    FilteredVector direction;
  };

  long shift = 0;  ///< of the doubles of coordinates
  std::vector<FilteredVector> points;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  std::vector<std::vector<std::uint32_t>> edges_at;  ///< by vertex
  std::vector<std::uint32_t> shell_vertices;         ///< one vertex of each connected surface

  /// `points` holds the vertices over one denominator.
  SpaceOperand(const Polyhedron& body, const std::vector<IntegerVector>& points, long shift);

  bool is_segment() const { return triangles.empty() && edges.size() == 1; }
  SpaceBox box_of(std::uint32_t triangle) const;
};

/// S P and Q over one denominator.
struct SpaceOperands {
  SpaceOperand P, Q;
  Integer denominator;
};
/// Throws BadInput ("bad-scale") unless every factor is positive. Exact.
SpaceOperands space_operands(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling);

/// A box of doubles around a point, a few doubles wider than the point's bounds.
inline SpaceBox box_around(const BoundedVector& point) {
  constexpr double infinity = SpaceBox::infinity;
  SpaceBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = point[k].value, error = point[k].error;
    // Covers rounding of the difference, the margin and the result, and the least double.
    const double margin = error == 0 ? 0 : error + (std::abs(value) + error) * 0x1p-51 + 1e-323;
    const double low = value - margin, high = value + margin;
    box.low[k] = std::isnan(low) ? -infinity : low;
    box.high[k] = std::isnan(high) ? infinity : high;
  }
  return box;
}

}  // namespace minkref::inline space
