// Readers and writers of polyhedra, one pair for each format (`mesh_format.cpp` has the table).
#pragma once

#include <string>
#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

// OFF, Geomview's format.

/// `#` comments; the word OFF; the numbers of vertices, faces and (ignored) edges, on the same line
/// or the next; one vertex a line; one face a line, its vertex count before the indices. Up to four
/// words after them, the colour, are skipped. C, N and ST before OFF announce vertex colours,
/// normals and texture coordinates: the reader skips everything after the three coordinates.
/// Refuses everything else with its line. Linear.
MeshReading read_off(std::string_view text, Input& input);
std::string write_off(const Polyhedron& polyhedron);

// OBJ, Wavefront's format.

/// Lines `v x y z` and `f a b c ...`; a corner of a face has the form v, v/vt, v//vn or v/vt/vn,
/// and only v counts: a vertex's number from 1, or from -1 backwards. The reader drops everything
/// after the coordinates of `v x y z 1` and `v x y z r g b`. A backslash at the end of a line,
/// comments aside, joins the next. Words for normals, texture, groups and materials are skipped.
/// Refused: points, lines, curves and surfaces (`p`, `l`, `curv`, ...), a fourth coordinate other
/// than 1, and words unknown to the format. Linear.
MeshReading read_obj(std::string_view text, Input& input);
std::string write_obj(const Polyhedron& polyhedron);

// STL, ASCII and binary.

/// Triangles without common vertices: equal coordinates become one vertex; vertices keep the order
/// of first use. Normals, names, the header and the attributes of a binary file are ignored. A file
/// of 84 + 50 n bytes, with n from its bytes 80 to 83, is binary (no text within the limits looks
/// so); every other file that begins with `solid`, with any case of letters, is ASCII with one
/// solid. Binary coordinates have the exact values of their bits. O(n log n).
MeshReading read_stl(std::string_view file, Input& input);
std::string write_stl(const Polyhedron& polyhedron);

// PLY, the format of Stanford, ASCII and binary.

/// Version 1.0: the properties x, y and z of the elements `vertex`, and the list vertex_indices or
/// vertex_index of the elements `face`, in any order and of any type that fits; skips other
/// elements and properties, but refuses triangle strips. ASCII: one element a line; a coordinate is
/// the exact number of its text, whatever its type. Binary: little or big endian; a coordinate is
/// the exact value of its bits. Linear.
MeshReading read_ply(std::string_view file, Input& input);
std::string write_ply(const Polyhedron& polyhedron);

// The plain JSON form.

/// Reads {"vertices":[[x,y,z],...],"faces":[[i,j,k,...],...]}: coordinates are strings or JSON
/// numbers, indices JSON integers from 0. Other members are refused. Linear.
MeshReading read_mesh_json(std::string_view text, Input& input);
/// {"faces":[[0,1,2],...],"vertices":[["x","y","z"],...]} on one line, numbers as strings.
std::string write_mesh_json(const Polyhedron& polyhedron);

}  // namespace minkref
