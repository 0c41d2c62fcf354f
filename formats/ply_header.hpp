// The header of a PLY file: the layout of its body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/input.hpp"

namespace minkref {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);  ///< in bytes
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;                   ///< of a list: of its values
  std::optional<PlyType> length;  ///< of a list: of its number of values
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;  ///< one or more, unless the count is 0
  std::size_t line = 0;
};

struct PlyHeader {
  enum class Encoding { ascii, little_endian, big_endian };
  Encoding encoding = Encoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0, lines = 0;  ///< up to the body
};

/// Whether the header of `file` announces a binary body. Nothing is refused here.
bool is_binary_ply(std::string_view file);

/// Refuses other text than a header of version 1.0, with the line: "syntax", "truncated",
/// "unsupported-encoding", "unsupported-version". Linear.
PlyHeader read_ply_header(std::string_view file, const Input& input);

}  // namespace minkref
