// The numbers of a binary file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "formats/input.hpp"

namespace minkref {

enum class ByteOrder { little, big };

/// Walks the bytes of a file from `begin` on. Refuses reading beyond the end ("truncated") and
/// names the byte.
class BinaryBytes {
 public:
  BinaryBytes(std::string_view file, std::size_t begin, ByteOrder order, const Input& input)
      : file_(file), at_(begin), order_(order), input_(input) {}

  std::size_t position() const { return at_; }
  std::size_t left() const { return file_.size() - at_; }

  /// An unsigned integer of 1 to 8 bytes.
  std::uint64_t bits(std::size_t size);
  float float32();
  double float64();
  void skip(std::uint64_t size);
  /// Refuses leftover bytes ("trailing-text"); `last` like "the last of 12 triangles".
  void require_end(const std::string& last) const;

 private:
  void require(std::uint64_t size) const;

  std::string_view file_;
  std::size_t at_;
  ByteOrder order_;
  const Input& input_;
};

}  // namespace minkref
