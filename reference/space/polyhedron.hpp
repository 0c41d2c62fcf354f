// The operand and the result in space: a closed surface of planar faces, exact coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/number/rational.hpp"

namespace minkref::inline space {

struct SpacePoint {
  Rational x, y, z;
  friend bool operator==(const SpacePoint&, const SpacePoint&) = default;
};

/// Indices of vertices, counter-clockwise seen from outside.
using Face = std::vector<std::uint32_t>;

/// A closed, orientable, 2-manifold surface mesh (docs/definitions.md, "Polyhedron"). Three
/// degenerate operands are written in the same form, without faces: the empty set (no vertex), a
/// point (one) and a segment (two).
struct Polyhedron {
  std::vector<SpacePoint> vertices;
  std::vector<Face> faces;

  bool empty() const { return vertices.empty(); }
  bool is_point() const { return faces.empty() && vertices.size() == 1; }
  bool is_segment() const { return faces.empty() && vertices.size() == 2; }
  bool is_solid() const { return !faces.empty(); }
  friend bool operator==(const Polyhedron&, const Polyhedron&) = default;
};

/// One factor for each axis, each positive.
using Scaling = std::array<Rational, 3>;

/// Refuses anything but a polyhedron (docs/definitions.md): reports the first fault, in this order.
/// Throws BadInput that names face, vertices and coordinates, or two faces and a point, and
/// LimitExceeded as integer_points does. Codes: the `validate_mesh` codes, then "self-intersection"
/// (the surface passes through itself), "overlapping-faces" (two faces share an area),
/// "wrong-orientation" (the volume is negative, or a shell inside out hollows out nothing) and
/// "shell-nesting" (a shell in the material of another). Exact. Near-linear if few face triangles
/// are close to each other without being neighbours, also if all are slivers (self_crossing.hpp),
/// O(n^2) at worst; beside cutting the faces into triangles (face_triangles.hpp).
void validate(const Polyhedron& polyhedron);

/// Checks everything that `validate` checks except the faces' mutual position: refuses anything but
/// a closed 2-manifold with planar simple faces. Codes: "index-out-of-range", "too-few-vertices",
/// "too-few-faces", "repeated-vertex" (a face visits a vertex twice), "unused-vertex",
/// "zero-length-edge", "zero-area", "non-planar-face", "face-not-simple", "wrong-orientation" (two
/// faces run along an edge the same way), "open-mesh" (an edge with one face), "non-manifold-edge"
/// (more than two), "non-manifold-vertex" (its faces are no single fan). Exact. O(n log n).
void validate_mesh(const Polyhedron& polyhedron);

/// As `validate`, but takes a plane polygon as well: a single face, planar and simple, that has all
/// vertices. Exact. O(n log n) for a polygon.
void validate_summand(const Polyhedron& polyhedron);

/// Checks the part of `validate` that all other functions presume: refuses a face that names a
/// nonexistent vertex, or has fewer than three. Linear.
void validate_faces(const Polyhedron& polyhedron);

/// Six times the volume, signed. Exact.
Rational sextuple_volume(const Polyhedron& polyhedron);

/// The same surface with equal vertices merged, numbered by first use within a face; drops vertices
/// without a face, unless the polyhedron has no face at all. Exact. O(n log n).
Polyhedron with_shared_vertices(const Polyhedron& polyhedron);

/// Throws BadInput ("bad-scale") unless every factor is positive.
void require_positive(const Scaling& scaling);

/// Multiplies every coordinate by the axis's factor, which has to be positive.
Polyhedron scaled(const Polyhedron& polyhedron, const Scaling& by);
Polyhedron translated(const Polyhedron& polyhedron, const SpacePoint& by);

}  // namespace minkref::inline space
