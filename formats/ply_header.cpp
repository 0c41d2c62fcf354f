#include "formats/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "formats/message_text.hpp"
#include "formats/text_lines.hpp"

namespace minkref {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> ply_types{{
    {"char", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"short", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"int", PlyType::int32},
    {"uint", PlyType::uint32},
    {"float", PlyType::float32},
    {"double", PlyType::float64},
    {"int8", PlyType::int8},
    {"uint8", PlyType::uint8},
    {"int16", PlyType::int16},
    {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},
    {"uint32", PlyType::uint32},
    {"float32", PlyType::float32},
    {"float64", PlyType::float64},
}};

/// The first byte after the line `end_header`; none if the line is missing.
std::optional<std::size_t> body_of(std::string_view file) {
  for (std::size_t begin = 0; begin < file.size();) {
    const std::size_t end = std::min(file.find('\n', begin), file.size());
    std::string_view line = file.substr(begin, end - begin);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    begin = std::min(end + 1, file.size());
    if (line == "end_header") return begin;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const Input& input)
      : input_(input), lines_(text, {.comments = false}) {}

  PlyHeader run() {
    const TextLine& first = lines_.due("the word ply", input_);
    if (first.tokens[0] != "ply" || first.tokens.size() > 1) {
      input_.refuse("syntax", in_quotes(first.tokens[0]) + " stands where the word ply is expected",
                    "begin the file with a line that says ply", first.number);
    }
    lines_.advance();
    while (lines_.due("end_header", input_).tokens[0] != "end_header") {
      line(*lines_.line());
      lines_.advance();
    }
    if (!has_format_) {
      input_.refuse("syntax", "the header has no `format` line",
                    "write `format ascii 1.0` after ply", lines_.last_number());
    }
    require_properties();
    header_.lines = lines_.last_number();
    return std::move(header_);
  }

 private:
  [[noreturn]] void refuse(const TextLine& line, const std::string& form) const {
    input_.refuse("syntax", "this line of the header is not of the form `" + form + "`",
                  "correct the line", line.number);
  }

  void line(const TextLine& line) {
    const std::string_view word = line.tokens[0];
    if (word == "comment" || word == "obj_info") return;
    if (word == "format") return format(line);
    if (word == "element") return element(line);
    if (word == "property") return property(line);
    input_.refuse("syntax", in_quotes(word) + " is not a word of a PLY header",
                  "correct it, or leave the line out", line.number);
  }

  void format(const TextLine& line) {
    if (line.tokens.size() != 3 || has_format_) refuse(line, "format ENCODING 1.0");
    has_format_ = true;
    const std::string_view encoding = line.tokens[1];
    if (encoding == "ascii") {
      header_.encoding = PlyHeader::Encoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyHeader::Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyHeader::Encoding::big_endian;
    } else {
      input_.refuse("unsupported-encoding", in_quotes(encoding) + " is not an encoding of PLY",
                    "give ascii, binary_little_endian or binary_big_endian", line.number);
    }
    if (line.tokens[2] != "1.0") {
      input_.refuse("unsupported-version", in_quotes(line.tokens[2]) + " is not a version of PLY",
                    "give a file of version 1.0", line.number);
    }
  }

  void element(const TextLine& line) {
    if (line.tokens.size() != 3) refuse(line, "element NAME COUNT");
    PlyElement element;
    element.name = line.tokens[1];
    element.count =
        input_.whole_number(line.tokens[2], "a number of elements", at_line(line.number));
    element.line = line.number;
    header_.elements.push_back(std::move(element));
  }

  PlyType type(std::string_view name, std::size_t line) const {
    for (const auto& [text, value] : ply_types) {
      if (text == name) return value;
    }
    input_.refuse("syntax", in_quotes(name) + " is not a type of PLY",
                  "give one of char, uchar, short, ushort, int, uint, float, double", line);
  }

  void property(const TextLine& line) {
    const std::vector<std::string_view>& tokens = line.tokens;
    if (header_.elements.empty()) {
      input_.refuse("syntax", "a property comes before the first element",
                    "put the line of its element before it", line.number);
    }
    PlyProperty property;
    if (tokens.size() == 5 && tokens[1] == "list") {
      property.length = type(tokens[2], line.number);
      if (!is_integer(*property.length)) {
        input_.refuse("syntax", "the length of a list is of the type " + in_quotes(tokens[2]),
                      "give it a type of integers", line.number);
      }
    } else if (tokens.size() != 3) {
      refuse(line, "property TYPE NAME` or `property list TYPE TYPE NAME");
    }
    property.type = type(tokens[tokens.size() - 2], line.number);
    property.name = tokens.back();
    header_.elements.back().properties.push_back(std::move(property));
  }

  /// An element without a property takes no room: a file could claim any number of them.
  void require_properties() const {
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0 || !element.properties.empty()) continue;
      input_.refuse("syntax", "the element " + in_quotes(element.name) + " has no property",
                    "add its properties, or leave it out", element.line);
    }
  }

  const Input& input_;
  TextLines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

bool is_binary_ply(std::string_view file) {
  const auto body = body_of(file);
  if (!body || !file.starts_with("ply")) return false;
  TextLines lines(file.substr(0, *body), {.comments = false});
  for (; lines.line(); lines.advance()) {
    const std::vector<std::string_view>& tokens = lines.line()->tokens;
    if (tokens[0] == "format") return tokens.size() > 1 && tokens[1].starts_with("binary");
  }
  return false;
}

PlyHeader read_ply_header(std::string_view file, const Input& input) {
  const std::size_t body = body_of(file).value_or(file.size());
  PlyHeader header = HeaderReader(file.substr(0, body), input).run();
  header.bytes = body;
  return header;
}

}  // namespace minkref
