// Mpfr: 53 bits mean 53, 24 mean 24, precision belongs to the value, nothing of the process
// changes.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/number/scalar.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_mpfr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Compares both arithmetics bit for bit, through a sequence of random operations.
template <class Float>
void compare_with(testing::Source& random, long precision, int exponents, int width) {
  using Bits = std::conditional_t<sizeof(Float) == 8, std::uint64_t, std::uint32_t>;
  const auto same = [](const Mpfr& ours, Float theirs) {
    const auto back = static_cast<Float>(approximate(ours));
    return exact(ours) == from_double(static_cast<double>(theirs)) &&
           std::bit_cast<Bits>(back) == std::bit_cast<Bits>(theirs);
  };
  for (int i = 0; i < 200'000; ++i) {
    const auto a =
        static_cast<Float>(random.with_exponent(-exponents, exponents, random.between(1, width)));
    const auto b = random.below(6) == 0
                       ? static_cast<Float>(-a * (1 + std::numeric_limits<Float>::epsilon()))
                       : static_cast<Float>(random.with_exponent(-exponents, exponents, width));
    const Mpfr x(static_cast<double>(a), precision), y(static_cast<double>(b), precision);
    ASSERT_TRUE(same(x, a) && same(y, b));
    ASSERT_TRUE(same(x + y, a + b)) << std::hexfloat << a << " + " << b;
    ASSERT_TRUE(same(x - y, a - b)) << std::hexfloat << a << " - " << b;
    ASSERT_TRUE(same(x * y, a * b)) << std::hexfloat << a << " * " << b;
    ASSERT_TRUE(same(x / y, a / b)) << std::hexfloat << a << " / " << b;
    ASSERT_TRUE(same(-x, -a));
    ASSERT_EQ(sign(x * y - y), sign(static_cast<double>(a * b - b)));
    ASSERT_EQ((x * y).precision(), precision);
  }
}

TEST(MpfrPrecision, FiftyThreeBitsAreDoublesBitForBit) {
  MINKREF_SEEDED(random, 21);
  compare_with<double>(random, 53, 300, 53);
  compare_with<double>(random, 53, 3, 53);
}

TEST(MpfrPrecision, TwentyFourBitsAreFloatsBitForBit) {
  MINKREF_SEEDED(random, 22);
  compare_with<float>(random, 24, 30, 24);
  compare_with<float>(random, 24, 2, 24);
}

TEST(MpfrPrecision, FiftyFiveAndFiftyOneBitsAreNotDoubles) {
  // 1/3 tells precisions apart, so the two tests above can fail.
  const Rational third = Rational(1) / 3;
  for (const long precision : {23L, 25L, 51L, 52L, 54L, 55L}) {
    EXPECT_NE(exact(Mpfr(third, precision)), from_double(1.0 / 3)) << precision;
    EXPECT_NE(exact(Mpfr(third, precision)), from_double(static_cast<double>(1.0F / 3)))
        << precision;
  }
}

TEST(MpfrPrecision, LongExpressionsRoundWhereDoublesRound) {
  MINKREF_SEEDED(random, 23);
  for (int i = 0; i < 20'000; ++i) {
    double a[6];
    std::vector<Mpfr> x;
    for (double& value : a) {
      value = random.with_exponent(-5, 5);
      x.emplace_back(value, 53);
    }
    const double theirs = (a[2] - a[0]) * (a[5] - a[1]) - (a[3] - a[1]) * (a[4] - a[0]);
    const Mpfr ours = (x[2] - x[0]) * (x[5] - x[1]) - (x[3] - x[1]) * (x[4] - x[0]);
    ASSERT_EQ(exact(ours), from_double(theirs));
  }
}

TEST(MpfrPrecision, ConversionFromRationalIsNearestWithTiesToEven) {
  MINKREF_SEEDED(random, 24);
  const Arithmetic<Mpfr> fifty_three(53);
  for (int i = 0; i < 50'000; ++i) {
    const Rational value = random.rational(120);
    ASSERT_EQ(exact(fifty_three(value)), from_double(to_double(value)));
  }
  EXPECT_EQ(approximate(Mpfr(Rational(5), 2)), 4);  // 4 = 1.0 2^2 and 6 = 1.1 2^2 tie
  EXPECT_EQ(approximate(Mpfr(Rational(7), 2)), 8);
  EXPECT_EQ(approximate(Mpfr(7.0, 2)), 8);
}

TEST(MpfrPrecision, ValuesKeepTheirDigitsWhereverTheyAreMoved) {
  const Rational third = Rational(1) / 3;
  for (const long before : {1L, 53L, 64L, 65L, 256L, 257L, 1000L}) {
    for (const long after : {2L, 200L, 256L, 257L, 5000L}) {
      const Mpfr first(third, before), second(-third, after);
      const Rational x = exact(first), y = exact(second);
      Mpfr a = first, b = second;
      std::swap(a, b);
      EXPECT_TRUE(exact(a) == y && exact(b) == x) << before << ' ' << after;
      EXPECT_TRUE(a.precision() == after && b.precision() == before);
      a = b;  // of another precision
      EXPECT_TRUE(exact(a) == x && a.precision() == before);
      a = std::move(b);
      b = second;  // one that was moved from takes a value again
      EXPECT_TRUE(exact(a) == x && exact(b) == y);
      Mpfr& same = a;
      a = same;
      a = std::move(same);
      EXPECT_EQ(exact(a), x);
      std::vector<Mpfr> grown;
      for (int i = 0; i < 9; ++i) grown.push_back(i % 2 == 0 ? first : second);
      for (int i = 0; i < 9; ++i) EXPECT_EQ(exact(grown[i]), i % 2 == 0 ? x : y);
    }
  }
}

TEST(MpfrPrecision, OnlyNumbersAreFinite) {
  for (const long precision : {53L, 300L}) {
    const Mpfr zero(0.0, precision), one(1.0, precision);
    EXPECT_TRUE(is_finite(zero) && is_finite(one));
    EXPECT_FALSE(is_finite(one / zero) || is_finite(zero / zero));
  }
}

TEST(MpfrPrecision, BinaryOperationsTakeTheLargerPrecisionOfTheTwo) {
  const Rational third = Rational(1) / 3;
  const Mpfr coarse(third, 24), fine(third, 100);
  for (const Mpfr& result : {coarse + fine, fine - coarse, coarse * fine, fine / coarse}) {
    EXPECT_EQ(result.precision(), 100);
  }
  EXPECT_EQ(exact(coarse - fine), exact(coarse) - exact(fine));  // 24 bits cancel: exact in 100
  Mpfr sum;
  sum += fine;
  EXPECT_EQ(sum.precision(), 100);
  EXPECT_EQ(sum, fine);
  sum -= coarse;
  EXPECT_EQ(sum.precision(), 100);
}

TEST(MpfrPrecision, LiteralsNeverChangeThePrecisionOfAResult) {
  const Mpfr x(Rational(1) / 3, 10);
  EXPECT_EQ(Mpfr().precision(), MPFR_PREC_MIN);
  EXPECT_EQ(Mpfr(3).precision(), 2);
  EXPECT_EQ(Mpfr(-1024).precision(), MPFR_PREC_MIN);
  EXPECT_EQ((x + 0).precision(), 10);
  EXPECT_EQ((2 * x).precision(), 10);
  for (const int value :
       {0, 1, -1, 7, -1000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    EXPECT_EQ(exact(Mpfr(value)), Rational(value));
  }
  EXPECT_EQ(exact(Mpfr(std::numeric_limits<long>::min())),
            Rational(std::numeric_limits<long>::min()));
  EXPECT_EQ(exact(Mpfr(~0UL)), Rational(~0UL));
}

TEST(MpfrPrecision, OutsideItsLimitsItIsRefused) {
  EXPECT_THROW(Mpfr(1.0, 0), BadInput);
  EXPECT_THROW(Mpfr(1.0, -53), BadInput);
  EXPECT_THROW(Arithmetic<Mpfr>(0), BadInput);
  EXPECT_THROW(Mpfr(Rational(1), std::numeric_limits<long>::max()), LimitExceeded);
  EXPECT_THROW(Arithmetic<Mpfr>(Mpfr::largest_precision + 1), LimitExceeded);
  EXPECT_EQ(Mpfr(1.0, 1).precision(), 1);
}

TEST(MpfrState, NothingOfTheProcessIsReadOrChanged) {
  const auto state = [] {
    return std::vector<long>{mpfr_get_default_prec(), mpfr_get_emin(), mpfr_get_emax(),
                             mpfr_get_default_rounding_mode(), std::fegetround()};
  };
  const auto work = [] {
    Mpfr value(Rational(1) / 3, 53);
    for (int i = 1; i < 100; ++i)
      value = (value * Mpfr(i, 53) + Mpfr(0.1, 24)) / Mpfr(Rational(i), 200);
    Mpfr moved = std::move(value);
    return exact(moved - Mpfr(2) * moved);
  };
  const std::vector<long> before = state();
  const Rational usual = work();
  EXPECT_EQ(state(), before);
  // Another default precision and rounding mode, set by someone else, change no result.
  mpfr_set_default_prec(7);
  mpfr_set_default_rounding_mode(MPFR_RNDU);
  const Rational unusual = work();
  EXPECT_EQ(mpfr_get_default_prec(), 7);
  EXPECT_EQ(mpfr_get_default_rounding_mode(), MPFR_RNDU);
  mpfr_set_default_prec(before[0]);
  mpfr_set_default_rounding_mode(MPFR_RNDN);
  EXPECT_EQ(unusual, usual);
}

TEST(MpfrValue, CopiesAndMovesCarryValueAndPrecision) {
  const Mpfr third(Rational(1) / 3, 77);
  Mpfr copy = third, other(2.5, 3);
  EXPECT_EQ(copy, third);
  EXPECT_EQ(copy.precision(), 77);
  other = third;
  EXPECT_EQ(other.precision(), 77);
  Mpfr& same = other;
  other = same;
  EXPECT_EQ(other, third);
  Mpfr taken = std::move(copy);
  EXPECT_EQ(taken, third);
  EXPECT_EQ(taken.precision(), 77);
  copy = taken;  // a moved-from value can be assigned to
  EXPECT_EQ(copy, third);
  std::swap(copy, other = Mpfr(1.0, 5));
  EXPECT_EQ(other, third);
  EXPECT_EQ(copy.precision(), 5);
}

TEST(MpfrValue, ComparesByValueAndNaNIsUnordered) {
  EXPECT_EQ(Mpfr(0.5, 53), Mpfr(0.5, 1));
  EXPECT_LT(Mpfr(Rational(1) / 3, 24), Mpfr(0.5, 1));
  const Mpfr nan(std::nan(""), 53);
  EXPECT_FALSE(nan == nan);
  EXPECT_FALSE(nan < Mpfr(1) || nan > Mpfr(1));
}

TEST(MpfrSign, IsThatOfTheRoundedValueAndNaNIsUndecided) {
  EXPECT_EQ(sign(Mpfr(-2.5, 53)), -1);
  EXPECT_EQ(sign(Mpfr()), 0);
  EXPECT_EQ(sign(Mpfr(Rational(1) / 3, 53) * 3 - 1), 0);  // rounds to 1: exactly what it shall show
  EXPECT_EQ(sign(Mpfr(infinity, 53)), 1);
  EXPECT_THROW(sign(Mpfr(0) / Mpfr(0)), UndecidedSign);
  EXPECT_THROW(exact(Mpfr(1) / Mpfr(0)), BadInput);
}

}  // namespace
}  // namespace minkref::of_mpfr
