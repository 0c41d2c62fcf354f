// A mesh with floating-point coordinates, and the effects of rounding.
#pragma once

#include <cstdint>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

enum class Precision : std::uint8_t { float64, float32 };

/// The effects of rounding a mesh's coordinates.
struct RoundingReport {
  std::uint64_t moved_vertices = 0;    ///< with other coordinates than before
  std::uint64_t merged_vertices = 0;   ///< how many distinct points were lost
  std::uint64_t degenerate_faces = 0;  ///< with a triangle that lost its area
  std::uint64_t turned_faces = 0;  ///< with a triangle turned over: its normal makes an angle of 90
                                   ///< degrees or more with the old one
  std::uint64_t bent_faces = 0;    ///< of more than three vertices, no longer in a plane
  Rational largest_displacement = 0;  ///< along an axis, of a vertex
};

struct RoundedMesh {
  Polyhedron mesh;  ///< every coordinate a number of the precision
  RoundingReport report;
};

/// Rounds every coordinate to the nearest number of the precision; keeps the given faces, so that
/// the mesh stays closed: certainly as a list of faces by vertex number, though readers that see
/// only coordinates (STL) take merged vertices for one. Faces with more than three vertices, planar
/// and simple, are judged by the triangles that `face_triangles` cuts (BadInput "not-representable"
/// if it cannot, LimitExceeded as integer_points does). Whether rounding makes two faces cross is
/// not checked. Exact. Throws LimitExceeded ("not-representable") for a coordinate beyond the range
/// of the precision. O(n log n) for triangles.
RoundedMesh rounded_mesh(const Polyhedron& mesh, Precision precision = Precision::float64);

}  // namespace minkref::inline space
