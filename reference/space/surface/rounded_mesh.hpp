// A mesh in floating point, and what rounding has done to it.
#pragma once

#include <cstdint>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

enum class Precision : std::uint8_t { float64, float32 };

/// The effects of rounding the coordinates of a mesh.
struct RoundingReport {
  std::uint64_t moved_vertices = 0;    ///< that no longer are where they were
  std::uint64_t merged_vertices = 0;   ///< by how many there are fewer different points
  std::uint64_t degenerate_faces = 0;  ///< of which a triangle has no area any more
  std::uint64_t turned_faces = 0;  ///< of which a triangle is turned over: its normal has an angle
                                   ///< of 90 degrees or more to the one before
  std::uint64_t bent_faces = 0;    ///< of more than three vertices, no longer in a plane
  Rational largest_displacement = 0;  ///< along an axis, of a vertex
};

struct RoundedMesh {
  Polyhedron mesh;  ///< every coordinate a number of the precision
  RoundingReport report;
};

/// Every coordinate is the nearest number of the precision; the faces are the given ones, so that
/// the mesh stays closed: certainly as a list of faces by the numbers of their vertices, though
/// readers of coordinates only (STL) take merged vertices for one. Faces of more than three
/// vertices, planar and simple, are judged by the triangles into which `face_triangles` cuts them
/// (BadInput "not-representable" where they cannot be cut, LimitExceeded as integer_points does).
/// Whether rounding makes two faces cross is not checked. Exact. Throws LimitExceeded
/// ("not-representable") for a coordinate beyond the range of the precision. O(n log n) for
/// triangles.
RoundedMesh rounded_mesh(const Polyhedron& mesh, Precision precision = Precision::float64);

}  // namespace minkref::inline space
