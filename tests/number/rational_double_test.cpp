// Rationals against doubles: exact one way, correctly rounded the other way.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "reference/error.hpp"
#include "reference/number/rational.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_rational_double {
namespace {

constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

Rational power_of_two(int exponent) {
  const Rational power(Integer(1) << std::abs(exponent));
  return exponent < 0 ? Rational(1 / power) : power;
}

/// Round half to even, from the definition: no double is nearer, and of two equally near the even
/// one.
bool is_nearest(const Rational& value, double candidate) {
  if (std::isinf(candidate)) {
    const Rational bound =
        from_double(greatest) + power_of_two(970);  // halfway to 2^1024; ties go out
    return candidate > 0 ? value >= bound : value <= -bound;
  }
  const Rational distance = abs(value - from_double(candidate));
  const bool even = (std::bit_cast<std::uint64_t>(candidate) & 1) == 0;
  for (const double towards : {-infinity, infinity}) {
    const double neighbour = std::nextafter(candidate, towards);
    const Rational place = std::isinf(neighbour)
                               ? Rational(neighbour > 0 ? 1 : -1) * power_of_two(1024)
                               : from_double(neighbour);
    const Rational other = abs(value - place);
    if (other < distance || (other == distance && !even)) return false;
  }
  return true;
}

TEST(RationalToDouble, EveryDoubleComesBack) {
  MINKREF_SEEDED(random, 1);
  for (int i = 0; i < 200'000; ++i) {
    const double value = random.finite();
    ASSERT_EQ(to_double(from_double(value)), value);
  }
  for (const double value : {0.0, least, -least, greatest, -greatest,
                             std::numeric_limits<double>::min(), 0x0.fffffffffffffp-1022}) {
    EXPECT_EQ(to_double(from_double(value)), value);
  }
}

TEST(RationalToDouble, NearestWithTiesToEvenOverTheWholeRange) {
  MINKREF_SEEDED(random, 2);
  for (int i = 0; i < 50'000; ++i) {
    const Rational value = random.rational(200) * power_of_two(random.between(-1100, 1000));
    ASSERT_TRUE(is_nearest(value, to_double(value))) << to_string(value);
  }
}

TEST(RationalToDouble, TiesAndTheirNeighboursAreRoundedRight) {
  MINKREF_SEEDED(random, 3);
  for (int i = 0; i < 50'000; ++i) {
    const double below = std::abs(random.finite());
    if (below == greatest) continue;
    const Rational low = from_double(below), high = from_double(std::nextafter(below, infinity));
    const Rational tie = (low + high) / 2,
                   nudge = (high - low) * power_of_two(-random.between(2, 200));
    for (const Rational& value : {tie, Rational(tie - nudge), Rational(tie + nudge)}) {
      ASSERT_TRUE(is_nearest(value, to_double(value))) << below;
      ASSERT_EQ(to_double(-value), -to_double(value));
    }
  }
}

TEST(RationalToDouble, EndsOfTheRange) {
  const Rational half_least = power_of_two(-1075), tiny = power_of_two(-3000);
  EXPECT_EQ(to_double(half_least), 0);  // a tie: zero is even
  EXPECT_EQ(to_double(half_least + tiny), least);
  EXPECT_EQ(to_double(half_least * 3), 2 * least);
  EXPECT_EQ(to_double(half_least * 3 - tiny), least);
  EXPECT_EQ(to_double(tiny), 0);
  EXPECT_EQ(to_double(-tiny), 0);
  const Rational edge = from_double(greatest) + power_of_two(970);
  EXPECT_EQ(to_double(edge), infinity);
  EXPECT_EQ(to_double(-edge), -infinity);
  EXPECT_EQ(to_double(edge - tiny), greatest);
  EXPECT_EQ(to_double(power_of_two(1024)), infinity);
  EXPECT_EQ(to_double(power_of_two(100'000)), infinity);
  EXPECT_EQ(to_double(1 - power_of_two(-54)), 1);
  EXPECT_EQ(to_double(parse_rational("1e-400")), 0);
  EXPECT_EQ(to_double(parse_rational("4.9406564584124654e-324")), least);
}

TEST(RationalToDouble, AgreesWithTheCompilersReadingOfDecimals) {
  MINKREF_SEEDED(random, 4);
  for (int i = 0; i < 50'000; ++i) {
    const std::string text = random.integer(random.between(1, 70)).str() + "e" +
                             std::to_string(random.between(-345, 300));
    ASSERT_EQ(to_double(parse_rational(text)), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(RationalEnclosure, IsTheTightestAndAPointOnlyWhereExact) {
  MINKREF_SEEDED(random, 5);
  for (int i = 0; i < 50'000; ++i) {
    const Rational value = random.coin()
                               ? from_double(random.finite())
                               : random.rational(90) * power_of_two(random.between(-1100, 1040));
    const Enclosure around = enclose(value);
    if (!std::isinf(around.lower)) {
      ASSERT_LE(from_double(around.lower), value);
    }
    if (!std::isinf(around.upper)) {
      ASSERT_GE(from_double(around.upper), value);
    }
    ASSERT_NE(around.lower, infinity);
    ASSERT_NE(around.upper, -infinity);
    if (around.lower == around.upper) {
      ASSERT_EQ(from_double(around.lower), value);
    } else {
      ASSERT_EQ(std::nextafter(around.lower, infinity), around.upper);
      if (!std::isinf(around.lower)) {
        ASSERT_LT(from_double(around.lower), value);
      }
      if (!std::isinf(around.upper)) {
        ASSERT_GT(from_double(around.upper), value);
      }
    }
  }
}

TEST(RationalFromDouble, IsTheExactBinaryValue) {
  EXPECT_EQ(to_string(from_double(0.1)), "3602879701896397/36028797018963968");
  EXPECT_EQ(from_double(least), power_of_two(-1074));
  EXPECT_EQ(from_double(-0.0), 0);
}

TEST(RationalFromDouble, NaNAndInfinityAreRefused) {
  for (const double value : {std::nan(""), infinity, -infinity}) {
    try {
      from_double(value);
      ADD_FAILURE() << "accepted " << value;
    } catch (const BadInput& refusal) {
      EXPECT_EQ(refusal.code(), "not-a-number");
    }
  }
}

}  // namespace
}  // namespace minkref::of_rational_double
