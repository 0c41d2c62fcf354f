// Intervals: tightest operations, enclosures of whole expressions, and signs that are right or
// refused.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "reference/number/scalar.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_interval {
namespace {

constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

bool encloses(const Interval& interval, const Rational& value) {
  return (std::isinf(interval.lower()) || from_double(interval.lower()) <= value) &&
         (std::isinf(interval.upper()) || from_double(interval.upper()) >= value) &&
         interval.lower() != infinity && interval.upper() != -infinity;
}

enum class Operation { add, subtract, multiply, divide };
constexpr Operation operations[] = {Operation::add, Operation::subtract, Operation::multiply,
                                    Operation::divide};

template <class T>
T apply(Operation operation, const T& a, const T& b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      break;
  }
  return a / b;
}

void expect_bounds(const Interval& got, double lower, double upper) {
  EXPECT_EQ(got.lower(), lower);
  EXPECT_EQ(got.upper(), upper);
}

TEST(IntervalOperation, OnPointsIsTheTightestEnclosureOfTheExactResult) {
  MINKREF_SEEDED(random, 11);
  for (int i = 0; i < 200'000; ++i) {
    const double a = random.finite(), b = random.below(8) == 0 ? -a : random.finite();
    const Rational exact_a = from_double(a), exact_b = from_double(b);
    for (const Operation operation : operations) {
      if (operation == Operation::divide && b == 0) continue;
      const Interval got = apply(operation, Interval(a), Interval(b));
      const Enclosure tightest = enclose(apply(operation, exact_a, exact_b));
      ASSERT_EQ(got.lower(), tightest.lower)
          << std::hexfloat << a << ' ' << b << ' ' << static_cast<int>(operation);
      ASSERT_EQ(got.upper(), tightest.upper)
          << std::hexfloat << a << ' ' << b << ' ' << static_cast<int>(operation);
    }
  }
}

TEST(IntervalOperation, OnIntervalsIsTheTightestEnclosureOfTheFourCorners) {
  MINKREF_SEEDED(random, 12);
  const auto interval = [&random] {
    const double a = random.finite(), b = random.below(6) == 0 ? 0.0 : random.finite();
    return Interval(std::min(a, b), std::max(a, b));
  };
  for (int i = 0; i < 50'000; ++i) {
    const Interval a = interval(), b = interval();
    for (const Operation operation : operations) {
      const Interval got = apply(operation, a, b);
      if (operation == Operation::divide && b.contains_zero()) {
        expect_bounds(got, -infinity, infinity);
        continue;
      }
      std::optional<Rational> low, high;
      for (const double x : {a.lower(), a.upper()}) {
        for (const double y : {b.lower(), b.upper()}) {
          const Rational corner = apply(operation, from_double(x), from_double(y));
          if (!low || corner < *low) low = corner;
          if (!high || corner > *high) high = corner;
        }
      }
      ASSERT_EQ(got.lower(), enclose(*low).lower);
      ASSERT_EQ(got.upper(), enclose(*high).upper);
    }
  }
}

/// A random expression evaluated over intervals and rationals side by side.
struct Pair {
  Interval interval;
  Rational exact;
};

Pair leaf(testing::Source& random, int range) {
  if (random.below(4) == 0) {
    const Rational value = random.rational();
    return {Interval(value), value};
  }
  const double value = range == 0   ? random.between(-4, 4)
                       : range == 1 ? random.with_exponent(-4, 4)
                                    : random.finite();
  return {Interval(value), from_double(value)};
}

Pair expression(testing::Source& random, int depth, int range) {
  if (depth == 0) return leaf(random, range);
  const Pair a = expression(random, depth - 1, range);
  const Pair b = random.below(8) == 0 ? a : expression(random, random.between(0, depth - 1), range);
  const Operation operation = operations[random.below(4)];
  if (operation == Operation::divide && b.exact == 0) return {-a.interval, -a.exact};
  return {apply(operation, a.interval, b.interval), apply(operation, a.exact, b.exact)};
}

TEST(IntervalRoot, EnclosesTheExactRootWithinTwoDoubles) {
  MINKREF_SEEDED(random, 12);
  for (int i = 0; i < 100'000; ++i) {
    const double a = std::abs(random.finite());
    const Interval got = sqrt(Interval(a));
    const Rational exact = from_double(a), low = from_double(got.lower()),
                   high = from_double(got.upper());
    ASSERT_LE(low * low, exact) << a;
    ASSERT_GE(high * high, exact) << a;
    ASSERT_LE(got.upper(), std::nextafter(std::nextafter(got.lower(), infinity), infinity)) << a;
  }
  for (const double root : {0.0, 1.0, 3.0, 0x1p-500, 0x1p500, 12345678.0}) {
    expect_bounds(sqrt(Interval(root * root)), root, root);
  }
  expect_bounds(sqrt(Interval(-4.0, 9.0)), 0, 3);
  EXPECT_EQ(sqrt(Interval(0.0, infinity)).upper(), infinity);
}

TEST(IntervalExpression, EnclosesTheExactValueAndItsSignIsRightOrRefused) {
  MINKREF_SEEDED(random, 13);
  int certified = 0, certified_zero = 0, refused = 0;
  for (int i = 0; i < 60'000; ++i) {
    const Pair value = expression(random, random.between(1, 5), i % 3);
    ASSERT_TRUE(encloses(value.interval, value.exact));
    if (const std::optional<int> answer = certified_sign(value.interval)) {
      ASSERT_EQ(*answer, sign(value.exact));
      ASSERT_EQ(sign(value.interval), *answer);
      ++(*answer == 0 ? certified_zero : certified);
    } else {
      ASSERT_THROW(sign(value.interval), UndecidedSign);
      ++refused;
    }
  }
  // All three answers were really exercised.
  EXPECT_GT(certified, 10'000);
  EXPECT_GT(certified_zero, 500);
  EXPECT_GT(refused, 500);
}

TEST(IntervalExpression, ExactOperationsStayPoints) {
  MINKREF_SEEDED(random, 14);
  for (int i = 0; i < 20'000; ++i) {
    // Products of 20-bit integers and their sums are doubles: a whole orientation test stays exact.
    const auto coordinate = [&random] {
      return static_cast<double>(random.between(-(1 << 20), 1 << 20));
    };
    const Interval ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    const Interval determinant = ax * by - ay * bx;
    ASSERT_TRUE(determinant.is_point());
    ASSERT_EQ(determinant.lower(), ax.lower() * by.lower() - ay.lower() * bx.lower());
    ASSERT_EQ(sign(ax * by - by * ax), 0);
  }
}

TEST(IntervalEnds, OverflowUnderflowAndInfinityKeepTheEnclosure) {
  expect_bounds(Interval(greatest) + Interval(greatest), greatest, infinity);
  expect_bounds(-Interval(greatest) - Interval(greatest), -infinity, -greatest);
  expect_bounds(Interval(greatest) + Interval(least), greatest, infinity);
  expect_bounds(Interval(greatest) - Interval(least), std::nextafter(greatest, 0), greatest);
  expect_bounds(Interval(greatest) - Interval(greatest), 0, 0);
  expect_bounds(Interval(greatest) * Interval(2), greatest, infinity);
  expect_bounds(Interval(greatest) * Interval(-2), -infinity, -greatest);
  expect_bounds(Interval(least) * Interval(0.5), 0, least);
  expect_bounds(Interval(least) * Interval(-0.5), -least, 0);
  expect_bounds(Interval(least) / Interval(2), 0, least);
  expect_bounds(Interval(least) / Interval(greatest), 0, least);
  expect_bounds(Interval(greatest) / Interval(-least), -infinity, -greatest);
  expect_bounds(Interval(0) * Interval::whole(), 0, 0);
  expect_bounds(Interval::whole() * Interval(0), 0, 0);
  expect_bounds(Interval(1) / Interval(1, infinity), 0, 1);
  expect_bounds(Interval(-1) / Interval(1, infinity), -1, 0);
  expect_bounds(Interval(1, infinity) / Interval(-infinity, -1), -infinity, 0);
  expect_bounds(Interval(1, infinity) * Interval(0, 1), 0, infinity);
  expect_bounds(Interval(0, infinity) * Interval(0, infinity), 0, infinity);
  expect_bounds(Interval(-infinity, 2) * Interval(-3, infinity), -infinity, infinity);
  expect_bounds(Interval(-infinity, 2) + Interval(1, infinity), -infinity, infinity);
  expect_bounds(Interval::whole() - Interval::whole(), -infinity, infinity);
  EXPECT_EQ(sign(Interval(least) * Interval(least) + Interval(least)), 1);
}

TEST(IntervalEnds, RandomOperationsOnUnboundedIntervalsNeverMakeNaNOrAnEmptyInterval) {
  MINKREF_SEEDED(random, 15);
  const auto bound = [&random](double end) { return random.below(3) == 0 ? end : random.finite(); };
  for (int i = 0; i < 100'000; ++i) {
    double bounds[4] = {bound(-infinity), bound(infinity), bound(-infinity), bound(infinity)};
    if (bounds[0] > bounds[1]) std::swap(bounds[0], bounds[1]);
    if (bounds[2] > bounds[3]) std::swap(bounds[2], bounds[3]);
    const Interval a(bounds[0], bounds[1]), b(bounds[2], bounds[3]);
    // Finite members of both intervals, whose results must be enclosed.
    const double x = std::isinf(a.lower()) ? std::min(a.upper(), greatest) : a.lower();
    const double y = std::isinf(b.upper()) ? std::max(b.lower(), -greatest) : b.upper();
    for (const Operation operation : operations) {
      const Interval got = apply(operation, a, b);
      ASSERT_LE(got.lower(), got.upper());
      ASSERT_NE(got.lower(), infinity);
      ASSERT_NE(got.upper(), -infinity);
      if (operation == Operation::divide && y == 0) continue;
      ASSERT_TRUE(encloses(got, apply(operation, from_double(x), from_double(y))));
    }
  }
}

TEST(IntervalConstruction, NaNAndInfinityGiveTheWholeLine) {
  for (const double value : {std::nan(""), infinity, -infinity}) {
    expect_bounds(Interval(value), -infinity, infinity);
    EXPECT_FALSE(certified_sign(Interval(value)));
  }
  expect_bounds(Interval(std::nan(""), 1), -infinity, infinity);
  EXPECT_THROW(Interval(2, 1), BadInput);
  EXPECT_THROW(Interval(infinity, infinity), BadInput);
}

TEST(IntervalConstruction, RationalsAndLargeIntegersGetTheirTightestEnclosure) {
  EXPECT_TRUE(Interval(Rational(3) / 8).is_point());
  const Interval third(Rational(1) / 3);
  EXPECT_EQ(std::nextafter(third.lower(), 1), third.upper());
  EXPECT_TRUE(encloses(third, Rational(1) / 3));
  const long large = (1L << 53) + 1;
  expect_bounds(Interval(large), 0x1p53, 0x1p53 + 2);
  expect_bounds(Interval(std::numeric_limits<std::int64_t>::min()), -0x1p63, -0x1p63);
  expect_bounds(Interval(std::numeric_limits<std::uint64_t>::max()), std::nextafter(0x1p64, 0),
                0x1p64);
}

TEST(IntervalDivision, DivisorWithZeroGivesTheWholeLine) {
  for (const Interval& divisor : {Interval(0), Interval(-1, 1), Interval(0, 1), Interval(-1, 0)}) {
    expect_bounds(Interval(1) / divisor, -infinity, infinity);
    EXPECT_THROW(sign(Interval(1) / divisor), UndecidedSign);
  }
}

TEST(IntervalState, RoundingModeIsNeverTouchedNorNeededOtherThanNearest) {
  ASSERT_EQ(std::fegetround(), FE_TONEAREST);
  MINKREF_SEEDED(random, 16);
  for (int i = 0; i < 1000; ++i) {
    const Interval a(random.finite()), b(random.finite());
    for (const Operation operation : operations) {
      (void)certified_sign(apply(operation, a, b));
      ASSERT_EQ(std::fegetround(), FE_TONEAREST);
    }
  }
}

TEST(IntervalApproximation, LiesInsideBoundedIntervals) {
  MINKREF_SEEDED(random, 17);
  for (int i = 0; i < 20'000; ++i) {
    const double a = random.finite(), b = random.finite();
    const Interval interval(std::min(a, b), std::max(a, b));
    const double middle = approximate(interval);
    ASSERT_GE(middle, interval.lower());
    ASSERT_LE(middle, interval.upper());
  }
  EXPECT_TRUE(std::isnan(approximate(Interval::whole())));
}

}  // namespace
}  // namespace minkref::of_interval
