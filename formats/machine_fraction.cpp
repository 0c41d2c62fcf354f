#include "formats/machine_fraction.hpp"

#include <gmp.h>

#include <array>
#include <bit>
#include <utility>

#include "reference/number/rational.hpp"

namespace minkref {
namespace {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits");

using Word = std::uint64_t;
__extension__ typedef unsigned __int128 UInt128;

UInt128 magnitude(Int128 value) {
  return value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
}
Word magnitude(std::int64_t value) {
  return value < 0 ? -static_cast<Word>(value) : static_cast<Word>(value);
}

/// A natural number of a few limbs with a nonzero last limb.
struct Natural {
  std::array<mp_limb_t, 5> limbs{};
  mp_size_t size = 0;

  Natural() = default;
  explicit Natural(UInt128 value)
      : limbs{static_cast<Word>(value), static_cast<Word>(value >> 64)} {
    size = limbs[1] != 0 ? 2 : limbs[0] != 0 ? 1 : 0;
  }
  bool is_one() const { return size == 1 && limbs[0] == 1; }
};

Natural times(const Natural& a, Word b) {
  Natural result;
  if (a.size == 0 || b == 0) return result;
  const mp_limb_t carry = mpn_mul_1(result.limbs.data(), a.limbs.data(), a.size, b);
  result.size = a.size;
  if (carry != 0) result.limbs[static_cast<std::size_t>(result.size++)] = carry;
  return result;
}

void divide_exactly(Natural& a, Word b) {
  if (a.size == 0 || b == 1) return;
  mpn_divrem_1(a.limbs.data(), 0, a.limbs.data(), a.size, b);
  while (a.size > 0 && a.limbs[static_cast<std::size_t>(a.size - 1)] == 0) --a.size;
}

/// `b` > 0.
Word common_divisor(const Natural& a, Word b) {
  return a.size == 0 ? b : mpn_gcd_1(a.limbs.data(), a.size, b);
}

UInt128 common_divisor(UInt128 a, UInt128 b) {
  const auto trailing = [](UInt128 value) {
    const Word low = static_cast<Word>(value);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<Word>(value >> 64));
  };
  if (a == 0 || b == 0) return a | b;
  const int shared = trailing(a | b);
  a >>= trailing(a);
  do {
    b >>= trailing(b);
    if (a > b) std::swap(a, b);
    b -= a;
  } while (b != 0);
  return a << shared;
}

/// a + b for equal signs, otherwise the difference; and whether the result is negative.
std::pair<Natural, bool> sum(const Natural& a, bool a_negative, const Natural& b, bool b_negative) {
  const bool a_first = a.size != b.size ? a.size > b.size
                       : a.size == 0    ? true
                                        : mpn_cmp(a.limbs.data(), b.limbs.data(), a.size) >= 0;
  const Natural &large = a_first ? a : b, &small = a_first ? b : a;
  if (small.size == 0) return {large, a_first ? a_negative : b_negative};
  Natural result;
  result.size = large.size;
  if (a_negative == b_negative) {
    const mp_limb_t carry = mpn_add(result.limbs.data(), large.limbs.data(), large.size,
                                    small.limbs.data(), small.size);
    if (carry != 0) result.limbs[static_cast<std::size_t>(result.size++)] = carry;
  } else {
    mpn_sub(result.limbs.data(), large.limbs.data(), large.size, small.limbs.data(), small.size);
    while (result.size > 0 && result.limbs[static_cast<std::size_t>(result.size - 1)] == 0) {
      --result.size;
    }
  }
  return {result, a_first ? a_negative : b_negative};
}

void append(std::string& text, Natural value) {
  if (value.size == 0) {
    text += '0';
    return;
  }
  std::array<unsigned char, 100> digits;  // of five limbs: 97 at the most
  const std::size_t count = mpn_get_str(digits.data(), 10, value.limbs.data(), value.size);
  std::size_t i = 0;
  while (i + 1 < count && digits[i] == 0) ++i;
  for (; i < count; ++i) text += static_cast<char>('0' + digits[i]);
}

}  // namespace

double nearest_double(const MachineFraction& value) {
  constexpr UInt128 longest = UInt128{1} << 53;
  if (magnitude(value.numerator) <= longest && magnitude(value.denominator) <= longest)
    return static_cast<double>(value.numerator) / static_cast<double>(value.denominator);
  return to_double(Rational(to_integer(value.numerator), to_integer(value.denominator)));
}

MachineFraction reduced(Int128 numerator, Int128 denominator) {
  const UInt128 divisor = common_divisor(magnitude(numerator), static_cast<UInt128>(denominator));
  if (divisor == 1) return {numerator, denominator};
  const UInt128 above = magnitude(numerator) / divisor;
  return {numerator < 0 ? -static_cast<Int128>(above) : static_cast<Int128>(above),
          static_cast<Int128>(static_cast<UInt128>(denominator) / divisor)};
}

void append(std::string& text, const MachineFraction& value) {
  if (value.numerator < 0) text += '-';
  append(text, Natural(magnitude(value.numerator)));
  if (value.denominator == 1) return;
  text += '/';
  append(text, Natural(magnitude(value.denominator)));
}

void append_position(std::string& text, const MachineFraction& scale, std::int64_t p,
                     std::int64_t q, std::uint64_t unit) {
  // With scale = n / d in lowest terms, n p + d q and d have the common divisor of p and d.
  Natural below(static_cast<UInt128>(scale.denominator));
  std::pair<Natural, bool> above;
  if (p == 0) {
    below = Natural(UInt128{1});
    above = {Natural(UInt128{magnitude(q)}), q < 0};
  } else {
    const Word shared = common_divisor(below, magnitude(p));
    divide_exactly(below, shared);
    above = sum(times(Natural(static_cast<UInt128>(scale.numerator)), magnitude(p) / shared), p < 0,
                times(below, magnitude(q)), q < 0);
  }
  if (above.first.size == 0) {
    text += '0';
    return;
  }
  const Word rest = common_divisor(above.first, unit);
  divide_exactly(above.first, rest);
  below = times(below, unit / rest);
  if (above.second) text += '-';
  append(text, above.first);
  if (below.is_one()) return;
  text += '/';
  append(text, below);
}

}  // namespace minkref
