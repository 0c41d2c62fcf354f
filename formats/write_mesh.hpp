// Writes polyhedra.
#pragma once

#include <string>

#include "formats/mesh_format.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref {

/// The text of a polyhedron, ending with a line break; STL and PLY become ASCII. The faces must
/// name existing vertices. MeshFormat::json is exact for every polyhedron. The others know decimals
/// only, exact if `writes_exactly` holds; other coordinates are rounded to the nearest double (17
/// digits), and the written polyhedron may then differ from the given one: faces of more than three
/// vertices may lose planarity. STL has triangles only: diagonals cut other faces. Throws BadInput
/// ("not-representable": STL has no points and no segments, and a face of more than three vertices
/// that is not planar and simple cannot be cut) and LimitExceeded ("not-representable": a rounded
/// coordinate leaves the range of doubles).
std::string write_mesh(const Polyhedron& polyhedron, MeshFormat format);

/// Whether reading the result of `write_mesh` yields the same polyhedron: always for json; for OFF,
/// OBJ and PLY iff every denominator is a product of twos and fives; for STL iff besides all faces
/// are triangles, all vertices belong to faces and no two are equal; reading STL numbers the
/// vertices anew, by first use.
bool writes_exactly(const Polyhedron& polyhedron, MeshFormat format);

}  // namespace minkref
