// Trapezoids for flat faces whose triangles are slivers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// A flat face's part between two edges, below and above, and two walls across the face; a triangle
/// if both edges meet at a wall.
struct FlatPiece {
  struct Side {
    FilteredVector start, along;  ///< a point of its line, and the direction, counter-clockwise
    std::uint32_t edge;           ///< of the operand; none for a wall
  };
  /// point / weight, weight > 0; the operand's vertex there, or none.
  struct Corner {
    IntegerVector point;
    Integer weight = 1;
    std::uint32_t vertex = space::none;
  };
  std::uint8_t size = 0;
  std::array<Side, 4> sides;           ///< each from its corner to the next
  std::array<Corner, 4> corners;       ///< counter-clockwise, seen from outside
  std::array<std::uint32_t, 2> edges;  ///< of the operand: below and above
};

/// Faces with many corners, and their pieces.
struct FlatPieces {
  struct OfFace {
    std::uint32_t triangle;                 ///< one of the face's
    std::vector<FlatPiece> pieces;          ///< cover the face once
    std::vector<std::uint32_t> bare_edges;  ///< of the outline, neither below nor above a piece
  };
  std::vector<std::uint32_t> face_of;  ///< for each triangle; none for other faces
  std::vector<OfFace> pieces;
};

/// Below this gain pieces cost more than they save.
inline constexpr double usual_gain = 16;

/// Joins coplanar triangles across edges to faces, and cuts each face along walls up and down from
/// all corners (a sweep). Keeps triangles for plane polygons, and unless the triangles' boxes
/// together have `least_gain` times the area that the pieces' boxes have. Exact. O(n log n).
FlatPieces flat_pieces(const SpaceOperand& body, double least_gain = usual_gain);

}  // namespace minkref::inline space
