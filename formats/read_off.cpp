#include <string>

#include "formats/mesh_builder.hpp"
#include "formats/mesh_formats.hpp"
#include "formats/message_text.hpp"
#include "formats/text_lines.hpp"

namespace minkref {
namespace {

bool take(std::string_view& rest, std::string_view prefix) {
  if (!rest.starts_with(prefix)) return false;
  rest.remove_prefix(prefix.size());
  return true;
}

class OffReader {
 public:
  OffReader(std::string_view text, Input& input)
      : input_(input), mesh_(input, Positions::lines), lines_(text) {}

  MeshReading run() {
    header();
    counts();
    for (std::size_t i = 0; i < vertices_; ++i) vertex();
    for (std::size_t i = 0; i < faces_; ++i) face();
    if (lines_.line()) {
      input_.refuse(
          "trailing-text", "there is text after the last of " + std::to_string(faces_) + " faces",
          "correct the numbers of vertices and faces, or remove the text", lines_.line()->number);
    }
    return mesh_.finish();
  }

 private:
  void header() {
    const TextLine& line = lines_.due("the word OFF", input_);
    std::string_view rest = line.tokens[0];
    const bool texture = take(rest, "ST"), colour = take(rest, "C"), normal = take(rest, "N");
    more_numbers_ = texture || colour || normal;
    if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF") {
      input_.refuse(
          "unsupported-geometry",
          in_quotes(line.tokens[0]) + " announces vertices that have not three coordinates",
          "give vertices of three coordinates, under the word OFF", line.number);
    }
    if (rest != "OFF") {
      input_.refuse("syntax", in_quotes(line.tokens[0]) + " stands where the word OFF is expected",
                    "begin the file with a line that says OFF", line.number);
    }
    after_header_ = 1;
    if (line.tokens.size() > 1 && line.tokens[1] == "BINARY") {
      input_.refuse("unsupported-encoding", "binary OFF is not read",
                    "save the file as ASCII, or as PLY", line.number);
    }
    if (line.tokens.size() > 1) return;
    lines_.advance();
    after_header_ = 0;
  }

  void counts() {
    const TextLine& line = lines_.due("the number of vertices", input_);
    const std::size_t given = line.tokens.size() - after_header_;
    if (given != 2 && given != 3) {
      input_.refuse("syntax", "three counts are due here: of vertices, faces and edges",
                    "write, for example, \"8 6 12\"; the number of edges may be 0", line.number);
    }
    const auto count = [&](std::size_t k, const char* what) {
      return input_.whole_number(line.tokens[after_header_ + k], what, at_line(line.number));
    };
    vertices_ = count(0, "a number of vertices");
    faces_ = count(1, "a number of faces");
    if (given == 3) count(2, "a number of edges");
    lines_.advance();
  }

  void vertex() {
    const std::string of = " of " + std::to_string(vertices_);
    const TextLine& line =
        lines_.due("vertex " + std::to_string(mesh_.vertices() + 1) + of, input_);
    const std::size_t given = line.tokens.size();
    if (given < 3 || (given > 3 && !more_numbers_)) {
      mesh_.refuse_vertex("syntax", "a vertex line must hold three numbers",
                          "write x, y and z, and check the number of vertices; colours are "
                          "announced by COFF, normals by NOFF",
                          line.number);
    }
    mesh_.vertex({line.tokens[0], line.tokens[1], line.tokens[2]}, line.number);
    lines_.advance();
  }

  void face() {
    const std::string of = " of " + std::to_string(faces_);
    const TextLine& line = lines_.due("face " + std::to_string(mesh_.faces() + 1) + of, input_);
    mesh_.begin_face(line.number);
    Place place = at_line(line.number);
    place.face = mesh_.faces() - 1;
    const std::size_t size = input_.whole_number(line.tokens[0], "a number of vertices", place);
    const std::size_t given = line.tokens.size() - 1;
    if (given < size || given - size > most_colour_words) {
      mesh_.refuse_face("syntax",
                        "the face has " + std::to_string(size) +
                            " vertices by its first number, "
                            "and " +
                            std::to_string(given) + " words follow",
                        "write the number of vertices, their indices, then perhaps a colour of up "
                        "to four numbers");
    }
    for (std::size_t k = 1; k <= size; ++k) {
      if (line.tokens[k].starts_with('-')) {
        mesh_.refuse_corner(printable(line.tokens[k].substr(0, 20)),
                            "vertices are numbered from 0");
      }
      mesh_.corner(input_.whole_number(line.tokens[k], "the number of a vertex", place));
    }
    mesh_.end_face();
    lines_.advance();
  }

  static constexpr std::size_t most_colour_words = 4;

  Input& input_;
  MeshBuilder mesh_;
  TextLines lines_;
  bool more_numbers_ = false;     ///< a line of a vertex goes on after the coordinates
  std::size_t after_header_ = 0;  ///< words before the counts on their line
  std::size_t vertices_ = 0, faces_ = 0;
};

}  // namespace

MeshReading read_off(std::string_view text, Input& input) { return OffReader(text, input).run(); }

}  // namespace minkref
