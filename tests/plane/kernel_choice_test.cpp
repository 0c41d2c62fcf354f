// The same sums under numbers that ask for a wider grid or for rationals.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_kernel_choice {
namespace {

Integer power(int base, unsigned exponent) {
  return boost::multiprecision::pow(Integer(base), exponent);
}

/// 2^exponent - 1: Mersenne primes, for the exponents used here.
Integer mersenne(unsigned exponent) { return (Integer(1) << exponent) - 1; }

std::string sum_is_stretched(const Case& c, const Rational& factor, const std::string& kernel) {
  const PolygonSet expected = stretched(minkowski_sum(c.P, c.Q, c.scale).region, factor);
  const Sum sum = minkowski_sum(stretched(c.P, factor), stretched(c.Q, factor), c.scale);
  if (!kernel.empty() && sum.statistics.kernel != kernel) {
    return "kernel " + sum.statistics.kernel + " and not " + kernel;
  }
  return unequal(expected, sum.region);
}

TEST(KernelChoice, SmallIntegersTakeTheGridOf64Bits) {
  MINKREF_SEEDED(random, 1900);
  expect_law(random, 60, [](const Case& c) { return sum_is_stretched(c, 1, "grid64"); });
}

TEST(KernelChoice, ACommonDenominatorIsTakenOut) {
  MINKREF_SEEDED(random, 1901);
  expect_law(random, 40, [](const Case& c) -> std::string {
    for (const unsigned k : {1U, 7U, 30U, 200U}) {
      const std::string fault = sum_is_stretched(c, Rational(Integer(1), power(3, k)), "");
      if (!fault.empty()) return fault;
    }
    return sum_is_stretched(c, Rational(1) / Rational(Integer(1) << 70), "");
  });
}

TEST(KernelChoice, WideIntegersTakeTheGridOf256Bits) {
  MINKREF_SEEDED(random, 1902);
  expect_law(random, 60, [](const Case& c) {
    // 10^30 has 100 bits; a small shift beside it prevents a common factor.
    const Point p{1, 0}, q{0, Rational(1, 7)};
    const Rational factor(power(10, 30));
    const PolygonSet P = shifted(stretched(c.P, factor), p), Q = shifted(stretched(c.Q, factor), q);
    const Sum sum = minkowski_sum(P, Q, c.scale);
    if (sum.statistics.kernel != "grid256") return "kernel " + sum.statistics.kernel;
    return unequal(
        shifted(stretched(minkowski_sum(c.P, c.Q, c.scale).region, factor), c.scale * p + q),
        sum.region);
  });
}

TEST(KernelChoice, DenominatorsThatShareNothingTakeRationals) {
  MINKREF_SEEDED(random, 1903);
  expect_law(random, 40, [](const Case& c) {
    // A linear map with four prime denominators, and a translation with four more.
    const auto map = [](const PolygonSet& set) {
      return mapped(set, [](const Point& p) {
        return Point{
            Rational(p.x + p.y / Rational(mersenne(61))),
            Rational(p.x / Rational(mersenne(89)) + p.y * Rational(Integer(3), mersenne(107)))};
      });
    };
    const Point p{Rational(Integer(1), mersenne(127)), Rational(Integer(5), mersenne(521))};
    const Sum sum = minkowski_sum(shifted(map(c.P), p), map(c.Q), c.scale);
    if (sum.statistics.kernel != "rational") return "kernel " + sum.statistics.kernel;
    const PolygonSet expected = canonicalize(map(minkowski_sum(c.P, c.Q, c.scale).region)).region;
    return unequal(shifted(expected, c.scale * p), sum.region);
  });
}

TEST(KernelChoice, AnyScaleAndTranslationGivesTheSameSumOnAllRoutes) {
  MINKREF_SEEDED(random, 1904);
  expect_law(random, 15, [](const Case& c) -> std::string {
    for (const unsigned bits :
         {20U, 50U, 61U, 62U, 63U, 64U, 65U, 100U, 127U, 128U, 254U, 255U, 256U, 257U, 600U}) {
      const Point p{Rational(Integer(1) << bits),
                    Rational(Integer(1), (Integer(1) << (bits / 2)) - 1)};
      const PolygonSet expected = shifted(minkowski_sum(c.P, c.Q, 1).region, p);
      for (const Route route : {Route::paper, Route::winding, Route::definition}) {
        const std::string fault =
            unequal(expected, minkowski_sum(shifted(c.P, p), c.Q, 1, route).region);
        if (!fault.empty()) return std::to_string(bits) + " bits: " + fault;
      }
    }
    return "";
  });
}

/// The largest absolute value of a coordinate.
Integer reach(const PolygonSet& set) {
  Integer result = 1;
  for_each_ring(set, [&](const Ring& ring) {
    for (const Point& p : ring) {
      for (const Rational& x : {p.x, p.y}) {
        const Integer up = Integer(abs(numerator(x)) / denominator(x)) + 1;
        if (up > result) result = up;
      }
    }
  });
  return result;
}

TEST(KernelChoice, AnyNumberOfBitsFromCornerToCorner) {
  // Both operands are equally large, with coordinates of both signs: differences of convolution
  // vertices are two bits wider than coordinates.
  MINKREF_SEEDED(random, 1906);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const auto around = [](const PolygonSet& set) {
      return shifted(stretched(set, 2), {-Rational(reach(set)), -Rational(reach(set))});
    };
    const PolygonSet P = around(c.P), Q = around(c.Q);
    const Case middle{stretched(P, Rational(reach(Q))), stretched(Q, Rational(reach(P))), 1};
    const Integer most = reach(P) * reach(Q);
    for (unsigned bits = 55; bits <= 66; ++bits) {
      for (const unsigned wide : {bits, bits + 190}) {
        const Rational factor((Integer(1) << wide) / most);
        const std::string fault = sum_is_stretched(middle, factor, "");
        if (!fault.empty()) return std::to_string(wide) + " bits: " + fault;
      }
    }
    return "";
  });
}

TEST(KernelChoice, ScalesOfManyDigits) {
  MINKREF_SEEDED(random, 1905);
  expect_law(random, 20, [](const Case& c) {
    const Rational factor(mersenne(521), mersenne(127));
    const PolygonSet expected = minkowski_sum(stretched(c.P, factor), c.Q, 1).region;
    return unequal(expected, minkowski_sum(c.P, c.Q, factor).region);
  });
}

TEST(KernelChoice, EverySignIsCounted) {
  const Statistics grid = minkowski_sum(box(0, 0, 1, 1), box(0, 0, 1, 2), 1).statistics;
  EXPECT_GT(grid.by_float + grid.by_integer, 0U);
  EXPECT_EQ(grid.by_rational, 0U);
  EXPECT_GT(grid.nodes, 0U);
  EXPECT_GT(grid.faces, 0U);
}

}  // namespace
}  // namespace minkref::testing::of_kernel_choice
