// Integers of one fixed length, as stored by an index.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/number/rational.hpp"

namespace minkref::inline plane {

/// Signed integers of `words` 64-bit words each: two's complement, the lowest word first.
struct IntegerColumn {
  std::uint32_t words = 1;
  std::span<const std::uint64_t> data;

  std::size_t size() const { return data.size() / words; }
  const std::uint64_t* at(std::size_t k) const { return data.data() + k * words; }
  Integer operator[](std::size_t k) const { return integer_of(at(k), words); }
  /// The fraction of integer k and the next one, which must be in lowest terms.
  Rational reduced(std::size_t k) const;

  static Integer integer_of(const std::uint64_t* words, std::uint32_t count);
};

/// The bit length of an integer, with a bit for the sign.
std::size_t signed_bits(const Integer& value);

/// Writes an integer; requires enough words.
void write_words(const Integer& value, std::uint64_t* words, std::uint32_t count);

/// Owner of a column.
struct IntegerWords {
  std::uint32_t words = 1;
  std::vector<std::uint64_t> data;
};
/// The integers with the fewest words that hold each.
IntegerWords integer_words(const std::vector<Integer>& values);

}  // namespace minkref::inline plane
