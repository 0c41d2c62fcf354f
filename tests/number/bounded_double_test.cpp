// Doubles with a bound: certain signs are right, and exact doubles are exact.
#include "reference/number/bounded_double.hpp"

#include <gtest/gtest.h>

#include <random>

namespace minkref::of_bounded_double {
namespace {

/// An integer of up to `most` bits, often near a power of two.
Integer random_integer(std::mt19937& dice, int most) {
  const int bits = std::uniform_int_distribution<int>(0, most)(dice);
  Integer value = Integer(1) << bits;
  value += std::uniform_int_distribution<int>(-2, 2)(dice);
  if (dice() % 2) value += Integer(dice()) << std::max(0, bits - 34);
  return dice() % 2 ? value : Integer(-value);
}

void expect_bounds(const BoundedDouble& bounded, const Rational& exact) {
  if (!std::isfinite(bounded.value) || !std::isfinite(bounded.error)) return;
  EXPECT_LE(abs(Rational(from_double(bounded.value) - exact)), from_double(bounded.error))
      << bounded.value << " " << to_string(exact);
  const int certain = bounded.certain_sign();
  if (certain != BoundedDouble::undecided) {
    EXPECT_EQ(certain, sign(exact));
  }
}

TEST(BoundedDouble, HoldsSumsProductsAndQuotients) {
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    const int most = seed % 2 ? 27 : 70;
    const Integer a = random_integer(dice, most), b = random_integer(dice, most),
                  c = random_integer(dice, most), d = random_integer(dice, most);
    const BoundedDouble x(a), y(b), z(c), w(d);
    expect_bounds(x, Rational(a));
    const long shift = std::uniform_int_distribution<long>(0, 1100)(dice);
    const Rational unit(Integer(1), Integer(1) << static_cast<unsigned long>(shift));
    const BoundedDouble short_x(a, shift), short_y(b, shift);
    expect_bounds(short_x * short_y - short_y, Rational(a * b) * unit * unit - Rational(b) * unit);
    expect_bounds(x + y, Rational(a + b));
    expect_bounds(x * y - z * w, Rational(a * b - c * d));
    expect_bounds((x - y) * (z + w) * x, Rational((a - b) * (c + d) * a));
    if (d.is_zero()) continue;
    const Rational quotient = Rational(c) / Rational(d);
    expect_bounds(z / w, quotient);
    expect_bounds(x - y * (z / w), Rational(a) - Rational(b) * quotient);
  }
}

TEST(BoundedDouble, IsCertainOfAZeroAmongShortIntegers) {
  EXPECT_EQ((BoundedDouble(3) * BoundedDouble(5) - BoundedDouble(15)).certain_sign(), 0);
}

TEST(BoundedDouble, IsNotExactAtTheEndOfTheShortIntegers) {
  const BoundedDouble most(Integer("9007199254740992")), one(1);  // 2^53
  EXPECT_EQ((most + one - most).certain_sign(), BoundedDouble::undecided);
}

TEST(BoundedDouble, IsNotCertainOfAZeroThatUnderflowMade) {
  const BoundedDouble tiny(Integer(3), 1200);
  EXPECT_EQ(tiny.certain_sign(), BoundedDouble::undecided);
  EXPECT_EQ((tiny * tiny).certain_sign(), BoundedDouble::undecided);
  EXPECT_EQ((tiny * tiny * BoundedDouble(5) - tiny).certain_sign(), BoundedDouble::undecided);
  EXPECT_EQ(BoundedDouble(Integer(0), 1200).certain_sign(), 0);
}

TEST(BoundedDouble, DecidesNothingBeyondTheRange) {
  const BoundedDouble huge(Integer("1" + std::string(400, '0')));
  EXPECT_EQ((huge - huge).certain_sign(), BoundedDouble::undecided);
  EXPECT_EQ((huge * huge - huge).certain_sign(), BoundedDouble::undecided);
  EXPECT_EQ((BoundedDouble(1) / BoundedDouble(0)).certain_sign(), BoundedDouble::undecided);
}

}  // namespace
}  // namespace minkref::of_bounded_double
