#include <algorithm>
#include <array>
#include <string>

#include "formats/mesh_builder.hpp"
#include "formats/mesh_formats.hpp"
#include "formats/message_text.hpp"
#include "formats/text_lines.hpp"

namespace minkref {
namespace {

/// Words whose lines say nothing about the surface.
constexpr std::array<std::string_view, 19> skipped = {
    "vn",     "vt",     "vp",     "g",          "o",        "s",        "mg",
    "usemtl", "mtllib", "usemap", "maplib",     "bevel",    "c_interp", "d_interp",
    "lod",    "ctech",  "stech",  "shadow_obj", "trace_obj"};
/// Words for elements outside polyhedra.
constexpr std::array<std::string_view, 19> unsupported = {
    "p",    "l",    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm",
    "trim", "hole", "scrv",   "sp",  "end",  "con",  "call", "csh",   "res"};

template <std::size_t size>
bool is_one_of(const std::array<std::string_view, size>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The numbers of one corner: v, v/vt, v//vn, v/vt/vn.
struct CornerText {
  std::array<std::string_view, 3> parts;
  std::size_t count = 0;  ///< 4: more than three
};

CornerText split(std::string_view token) {
  CornerText corner;
  while (corner.count < 3) {
    const std::size_t bar = token.find('/');
    corner.parts[corner.count++] = token.substr(0, bar);
    if (bar == std::string_view::npos) return corner;
    token.remove_prefix(bar + 1);
  }
  corner.count = 4;
  return corner;
}

bool is_whole(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_well_formed(const CornerText& corner) {
  if (corner.count > 3 || !is_whole(corner.parts[0])) return false;
  if (corner.count == 2) return is_whole(corner.parts[1]);
  if (corner.count == 1) return true;
  return (corner.parts[1].empty() || is_whole(corner.parts[1])) && is_whole(corner.parts[2]);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, Input& input)
      : input_(input),
        mesh_(input, Positions::lines, 1),
        lines_(text, LineRules{.comments = true, .continued = true}) {}

  MeshReading run() {
    for (; lines_.line(); lines_.advance()) element(*lines_.line());
    return mesh_.finish();
  }

 private:
  void element(const TextLine& line) {
    const std::string_view word = line.tokens[0];
    if (word == "v") return vertex(line);
    if (word == "f" || word == "fo") return face(line);
    if (is_one_of(skipped, word)) return;
    if (is_one_of(unsupported, word)) {
      input_.refuse("unsupported-geometry",
                    in_quotes(word) + " is an element that a polyhedron does not have",
                    "keep vertices and faces, and leave points, lines, curves and surfaces out",
                    line.number);
    }
    input_.refuse("unknown-word", in_quotes(word) + " is not a word of the format",
                  "correct it, or leave the line out", line.number);
  }

  void vertex(const TextLine& line) {
    const std::size_t given = line.tokens.size() - 1;
    if (given != 3 && given != 4 && given != 6) {
      mesh_.refuse_vertex("syntax", "a vertex line must hold three numbers",
                          "write v, x, y and z, then nothing, or 1, or a colour of three numbers",
                          line.number);
    }
    if (given == 4) require_weight_one(line);
    mesh_.vertex({line.tokens[1], line.tokens[2], line.tokens[3]}, line.number);
  }

  void require_weight_one(const TextLine& line) const {
    Place place = at_line(line.number);
    place.vertices.push_back(mesh_.vertices());
    if (input_.number(line.tokens[4], place) == 1) return;
    input_.refuse("unsupported-geometry",
                  "the vertex has the fourth coordinate " + in_quotes(line.tokens[4]),
                  "divide the vertex by it, and leave it out", place);
  }

  void face(const TextLine& line) {
    mesh_.begin_face(line.number);
    for (std::size_t k = 1; k < line.tokens.size(); ++k) corner(line.tokens[k], line.number);
    mesh_.end_face();
  }

  void corner(std::string_view token, std::size_t line) {
    const CornerText corner = split(token);
    if (!is_well_formed(corner)) {
      mesh_.refuse_face("syntax", in_quotes(token) + " is not a vertex of a face",
                        "write v, v/vt, v//vn or v/vt/vn, each the number of a line");
    }
    const std::string_view number = corner.parts[0];
    Place place = at_line(line);
    place.face = mesh_.faces() - 1;
    const bool backwards = number.starts_with('-');
    const std::size_t value =
        input_.whole_number(number.substr(backwards ? 1 : 0), "the number of a vertex", place);
    if (value == 0)
      mesh_.refuse_corner(std::string(number.substr(0, 20)), "vertices are numbered from 1");
    if (!backwards) return mesh_.corner(value - 1);
    if (value > mesh_.vertices()) {
      const std::size_t before = mesh_.vertices();
      mesh_.refuse_corner(std::string(number.substr(0, 20)),
                          before == 1 ? "one vertex stands before it"
                                      : std::to_string(before) + " vertices stand before it");
    }
    mesh_.corner(mesh_.vertices() - value);
  }

  Input& input_;
  MeshBuilder mesh_;
  TextLines lines_;
};

}  // namespace

MeshReading read_obj(std::string_view text, Input& input) { return ObjReader(text, input).run(); }

}  // namespace minkref
