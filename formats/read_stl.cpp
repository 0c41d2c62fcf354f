#include <algorithm>
#include <string>

#include "formats/binary_bytes.hpp"
#include "formats/file_text.hpp"
#include "formats/mesh_builder.hpp"
#include "formats/mesh_formats.hpp"
#include "formats/message_text.hpp"
#include "formats/text_lines.hpp"

namespace minkref {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

/// The length of a binary file with this beginning. Requires at least `header_bytes` bytes.
std::uint64_t stated_length(std::string_view file, const Input& input) {
  const std::uint64_t triangles = BinaryBytes(file, 80, ByteOrder::little, input).bits(4);
  return header_bytes + triangle_bytes * triangles;
}

bool is_word(std::string_view token, std::string_view word) {
  const auto small = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  return std::equal(token.begin(), token.end(), word.begin(), word.end(),
                    [&](char a, char b) { return small(a) == b; });
}

class AsciiReader {
 public:
  AsciiReader(std::string_view text, Input& input)
      : input_(input), mesh_(input, Positions::lines), lines_(text, {.comments = false}) {}

  MeshReading run() {
    std::size_t solids = 0;
    do {
      take("solid", "");
      while (is_word(lines_.due("`facet` or `endsolid`", input_).tokens[0], "facet")) facet();
      take("endsolid", "");
      ++solids;
    } while (lines_.line() && is_word(lines_.line()->tokens[0], "solid"));
    if (lines_.line()) {
      input_.refuse("trailing-text", "there is text after `endsolid`",
                    "keep solids in the file, and nothing else", lines_.line()->number);
    }
    if (solids > 1) {
      input_.warn(0, std::to_string(solids) + " solids are read as one polyhedron");
    }
    return mesh_.finish_shared();
  }

 private:
  const TextLine& due(const std::string& word, const std::string& second) const {
    const std::string expected = "`" + word + (second.empty() ? "" : " ") + second + "`";
    const TextLine& line = lines_.due(expected, input_);
    const bool first_is = is_word(line.tokens[0], word);
    const bool second_is =
        second.empty() || (line.tokens.size() > 1 && is_word(line.tokens[1], second));
    if (first_is && second_is) return line;
    input_.refuse("syntax", expected + " is expected, not " + in_quotes(line.tokens[0]),
                  "write, for each triangle, `facet normal`, `outer loop`, three lines of "
                  "`vertex`, `endloop` and `endfacet`",
                  line.number);
  }

  void take(const std::string& word, const std::string& second) {
    due(word, second);
    lines_.advance();
  }

  void facet() {
    mesh_.begin_face(due("facet", "normal").number);
    lines_.advance();
    take("outer", "loop");
    for (int k = 0; k < 3; ++k) vertex();
    take("endloop", "");
    take("endfacet", "");
    mesh_.end_face();
  }

  void vertex() {
    const TextLine& line = due("vertex", "");
    if (line.tokens.size() != 4) {
      mesh_.refuse_vertex("syntax", "a vertex line must hold three numbers",
                          "write `vertex`, x, y and z", line.number);
    }
    mesh_.vertex({line.tokens[1], line.tokens[2], line.tokens[3]}, line.number);
    mesh_.corner(mesh_.vertices() - 1);
    lines_.advance();
  }

  Input& input_;
  MeshBuilder mesh_;
  TextLines lines_;
};

MeshReading read_binary(std::string_view file, Input& input) {
  BinaryBytes bytes(file, header_bytes, ByteOrder::little, input);
  MeshBuilder mesh(input, Positions::bytes);
  while (bytes.left() > 0) {
    mesh.begin_face(bytes.position());
    bytes.skip(3 * sizeof(float));
    for (int k = 0; k < 3; ++k) {
      const std::size_t position = bytes.position();
      const double x = bytes.float32(), y = bytes.float32(), z = bytes.float32();
      mesh.vertex(std::array<double, 3>{x, y, z}, position);
      mesh.corner(mesh.vertices() - 1);
    }
    bytes.skip(2);
    mesh.end_face();
  }
  return mesh.finish_shared();
}

[[noreturn]] void refuse_length(std::string_view file, const Input& input) {
  const std::string length = std::to_string(file.size());
  if (file.size() < header_bytes) {
    input.refuse("truncated", "the file has " + length + " bytes, and a binary STL has 84 or more",
                 "complete the file");
  }
  const std::uint64_t stated = stated_length(file, input);
  input.refuse(file.size() < stated ? "truncated" : "trailing-text",
               "according to its bytes 80 to 83 the file has " + std::to_string(stated) +
                   " bytes, but it has " + length,
               "complete the file, or correct its number of triangles");
}

bool begins_with_solid(std::string_view text) {
  constexpr std::string_view word = "solid";
  const std::size_t begin = text.find_first_not_of(" \t\r\n\v\f");
  return begin != std::string_view::npos && is_word(text.substr(begin, word.size()), word);
}

}  // namespace

MeshReading read_stl(std::string_view file, Input& input) {
  require_size(file, input.source(), input.limits());
  if (file.size() >= header_bytes && file.size() == stated_length(file, input)) {
    return read_binary(file, input);
  }
  using namespace std::literals;
  const bool marked = file.starts_with("\xFF\xFE"sv) || file.starts_with("\xFE\xFF"sv);
  if (file.find('\0') != std::string_view::npos && !marked) refuse_length(file, input);
  const std::string_view text =
      plain_text(file, input.source(), input.limits(), "a line `solid` and a line `endsolid`");
  if (!begins_with_solid(text)) {
    input.refuse("syntax",
                 "the file neither begins with `solid` nor has the length of a binary STL",
                 "give an STL file: ASCII, or binary of 84 bytes and 50 for each triangle");
  }
  return AsciiReader(text, input).run();
}

}  // namespace minkref
