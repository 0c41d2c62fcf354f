// The values of a PLY file's body, one after the other, from text or bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "formats/binary_bytes.hpp"
#include "formats/input.hpp"
#include "formats/mesh_builder.hpp"
#include "formats/ply_header.hpp"
#include "formats/text_lines.hpp"

namespace minkref {

/// One element a line.
class PlyText {
 public:
  using Number = std::string_view;
  static constexpr Positions positions = Positions::lines;
  PlyText(std::string_view file, const PlyHeader& header, const Input& input);

  /// Begins the element `row` (from 0) of its kind.
  void begin(const PlyElement& element, std::size_t row);
  std::size_t position() const { return lines_.line()->number; }
  Number number(PlyType type);
  std::int64_t integer(PlyType type);
  void skip(PlyType type, std::uint64_t count);
  /// Refuses the element's remaining values ("syntax").
  void end();
  /// Refuses the file's remaining text ("trailing-text").
  void finish() const;

 private:
  std::string_view token();

  const Input& input_;
  TextLines lines_;
  std::size_t next_ = 0;
};

/// Without gaps.
class PlyBytes {
 public:
  using Number = double;
  static constexpr Positions positions = Positions::bytes;
  PlyBytes(std::string_view file, const PlyHeader& header, const Input& input);

  void begin(const PlyElement&, std::size_t) { position_ = bytes_.position(); }
  std::size_t position() const { return position_; }
  /// The exact value: a double holds every value of every type.
  Number number(PlyType type);
  std::int64_t integer(PlyType type);
  void skip(PlyType type, std::uint64_t count) { bytes_.skip(count * size_of(type)); }
  void end() {}
  void finish() const { bytes_.require_end("the last element"); }

 private:
  BinaryBytes bytes_;
  std::size_t position_ = 0;
};

}  // namespace minkref
