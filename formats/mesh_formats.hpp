// Readers and writers of polyhedra, one pair for each format (`mesh_format.cpp` has the table).
#pragma once

#include <string>
#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

// OFF, the format of Geomview.

/// `#` comments; the word OFF; the numbers of vertices, faces and (not looked at) edges, on the
/// same line or the next; one vertex a line; one face a line, its number of vertices before their
/// indices. Up to four words after them, the colour, are skipped. C, N and ST before OFF announce
/// colours, normals and texture coordinates of vertices: what follows the three coordinates is
/// skipped. Refuses everything else with its line. Linear.
MeshReading read_off(std::string_view text, Input& input);
std::string write_off(const Polyhedron& polyhedron);

// OBJ, the format of Wavefront.

/// Lines `v x y z` and `f a b c ...`; a corner of a face is v, v/vt, v//vn or v/vt/vn, of which v
/// counts: the number of a vertex from 1, or from -1 backwards. `v x y z 1` and `v x y z r g b` are
/// read without what follows the coordinates. A backslash at the end of a line, comments aside,
/// joins the next. Words that name normals, texture, groups and materials are skipped. Refused:
/// points, lines, curves and surfaces (`p`, `l`, `curv`, ...), a fourth coordinate other than 1,
/// and words that the format does not have. Linear.
MeshReading read_obj(std::string_view text, Input& input);
std::string write_obj(const Polyhedron& polyhedron);

// STL, ASCII and binary.

/// Triangles without common vertices: equal coordinates are made one vertex, numbered in the order
/// of first use. Normals, names, the header and the attributes of a binary file are not looked at.
/// A file whose length is 84 + 50 n bytes, with n as its bytes 80 to 83 have it, is binary (no text
/// within the limits is so), every other one that begins with `solid` is ASCII, in any case of
/// letters, one solid. Binary coordinates are the exact values of their bits. O(n log n).
MeshReading read_stl(std::string_view file, Input& input);
std::string write_stl(const Polyhedron& polyhedron);

// PLY, the format of Stanford, ASCII and binary.

/// Version 1.0: the properties x, y and z of the elements `vertex`, and the list vertex_indices or
/// vertex_index of the elements `face`, in any order and of any type that fits; other elements and
/// properties are skipped, save for triangle strips, which are refused. ASCII: one element a line,
/// a coordinate is the exact number of its text, whatever its type. Binary: little or big endian, a
/// coordinate is the exact value of its bits. Linear.
MeshReading read_ply(std::string_view file, Input& input);
std::string write_ply(const Polyhedron& polyhedron);

// The plain JSON form.

/// Reads {"vertices":[[x,y,z],...],"faces":[[i,j,k,...],...]}: coordinates are strings or JSON
/// numbers, indices JSON integers from 0. Other members are refused. Linear.
MeshReading read_mesh_json(std::string_view text, Input& input);
/// {"faces":[[0,1,2],...],"vertices":[["x","y","z"],...]} on one line, numbers as strings.
std::string write_mesh_json(const Polyhedron& polyhedron);

}  // namespace minkref
