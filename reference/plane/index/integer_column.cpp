#include "reference/plane/index/integer_column.hpp"

#include <algorithm>

namespace minkref::inline plane {
namespace {

/// Turns the words of a value into the words of -value.
void negate(std::uint64_t* words, std::uint32_t count) {
  std::uint64_t carry = 1;
  for (std::uint32_t k = 0; k < count; ++k) {
    words[k] = ~words[k] + carry;
    carry = carry != 0 && words[k] == 0 ? 1 : 0;
  }
}

void set(mpz_ptr to, const std::uint64_t* words, std::uint32_t count) {
  const bool negative = (words[count - 1] >> 63) != 0;
  if (count == 1) {
    mpz_set_si(to, static_cast<long>(words[0]));
  } else if (!negative) {
    mpz_import(to, count, -1, sizeof(std::uint64_t), 0, 0, words);
  } else {
    std::vector<std::uint64_t> magnitude(words, words + count);
    negate(magnitude.data(), count);
    mpz_import(to, count, -1, sizeof(std::uint64_t), 0, 0, magnitude.data());
    mpz_neg(to, to);
  }
}

}  // namespace

Integer IntegerColumn::integer_of(const std::uint64_t* words, std::uint32_t count) {
  Integer result;
  set(result.backend().data(), words, count);
  return result;
}

Rational IntegerColumn::reduced(std::size_t k) const {
  Rational result;
  set(mpq_numref(result.backend().data()), at(k), words);
  set(mpq_denref(result.backend().data()), at(k + 1), words);
  return result;
}

std::size_t signed_bits(const Integer& value) {
  return 1 + (value == 0 ? 0 : mpz_sizeinbase(value.backend().data(), 2));
}

void write_words(const Integer& value, std::uint64_t* words, std::uint32_t count) {
  std::fill(words, words + count, 0);
  mpz_export(words, nullptr, -1, sizeof(std::uint64_t), 0, 0, value.backend().data());
  if (value < 0) negate(words, count);
}

IntegerWords integer_words(const std::vector<Integer>& values) {
  IntegerWords result;
  std::size_t bits = 1;
  for (const Integer& value : values) bits = std::max(bits, signed_bits(value));
  result.words = static_cast<std::uint32_t>((bits + 63) / 64);
  result.data.resize(values.size() * result.words);
  for (std::size_t k = 0; k < values.size(); ++k) {
    write_words(values[k], result.data.data() + k * result.words, result.words);
  }
  return result;
}

}  // namespace minkref::inline plane
