// Writes polyhedra.
#pragma once

#include <string>

#include "formats/mesh_format.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref {

/// The text of a polyhedron, ending in a line break; STL and PLY are written as ASCII. The faces
/// must name vertices that exist. MeshFormat::json is exact for every polyhedron. The others know
/// decimals only: they are exact where `writes_exactly` says so; other coordinates are rounded to
/// the nearest double (17 digits), and the written polyhedron may then differ from the given one:
/// faces of more than three vertices may be no longer planar. STL has triangles only: other faces
/// are cut along diagonals. Throws BadInput ("not-representable": STL has no points and no
/// segments, and a face of more than three vertices that is not planar and simple cannot be cut)
/// and LimitExceeded
/// ("not-representable": a rounded coordinate leaves the range of doubles).
std::string write_mesh(const Polyhedron& polyhedron, MeshFormat format);

/// Whether reading what `write_mesh` gives yields the same polyhedron: always for json; for OFF,
/// OBJ and PLY iff every denominator is a product of twos and fives; for STL iff besides all faces
/// are triangles, all vertices belong to faces and no two are equal: its vertices are numbered
/// anew, in the order of their first use.
bool writes_exactly(const Polyhedron& polyhedron, MeshFormat format);

}  // namespace minkref
