// Exact numbers by expressions: signs against RootNumber, equal numbers in different looks.
#include "reference/number/radicals/surd.hpp"

#include <gtest/gtest.h>

#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/root_order.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_surds {
namespace {

TEST(Surd, OfEqualNumbersInDifferentLooksIsZero) {
  const FloatEnvironment standard;
  const auto root = [](int n) { return sqrt(Surd(n)); };
  EXPECT_EQ(sign(root(2) * root(3) - root(6)), 0);
  EXPECT_EQ(sign(sqrt(Surd(5) + Surd(2) * root(6)) - root(2) - root(3)), 0);
  EXPECT_EQ(sign(root(8) - Surd(2) * root(2)), 0);
  EXPECT_EQ(sign(Surd(1) / (root(2) + root(3) + root(5)) * (root(2) + root(3) + root(5)) - Surd(1)),
            0);
  EXPECT_EQ(sign(sqrt(root(2) + root(3)) * sqrt(root(2) + root(3)) - root(2) - root(3)), 0);
  const Surd nested = sqrt(Surd(7) + root(5)), other = sqrt(Surd(11) - root(3));
  EXPECT_EQ(sign((nested + other) * (nested - other) - (root(5) + root(3) - Surd(4))), 0);
}

TEST(Surd, TellsNearNumbersApart) {
  const FloatEnvironment standard;
  const Rational tiny(1, Integer(1) << 900U);
  const Surd root = sqrt(Surd(5) + Surd(2) * sqrt(Surd(6)));
  EXPECT_EQ(sign(root - sqrt(Surd(2)) - sqrt(Surd(3)) + Surd(tiny)), 1);
  EXPECT_EQ(sign(root - sqrt(Surd(2)) - sqrt(Surd(3)) - Surd(tiny)), -1);
}

/// A sum of many roots of roots: zero could not be told from numbers of millions of bits, yet its
/// distance from a fraction nearby is told by a few hundred.
TEST(Surd, TriesMoreBitsBeforeItRefuses) {
  const FloatEnvironment standard;
  Surd sum(0);
  for (const int prime : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43}) {
    sum = sum + sqrt(Surd(1) + sqrt(Surd(prime)));
  }
  Surd rest = sum;
  for (int k = 0; k < 8; ++k) {
    rest = rest - Surd(from_double(rest.enclosure(900).outwards().lower));
  }
  EXPECT_EQ(sign(rest), 1);
  EXPECT_EQ(sign(rest - Surd(Rational(1, Integer(1) << 300U))), -1);
  EXPECT_THROW(sign(rest * Surd(3) - (rest + rest + rest)), LimitExceeded);
}

TEST(Surd, RefusesZeroAsDivisorAndRootsOfNegativeNumbers) {
  const FloatEnvironment standard;
  EXPECT_THROW(Surd(1) / Surd(0), std::domain_error);
  EXPECT_THROW(sqrt(sqrt(Surd(2)) - sqrt(Surd(3))), std::domain_error);
}

/// a + b √m + (c + d √m) √(e + f √m) by both kinds of numbers, and the product with a conjugate.
TEST(Surd, HasTheSignsOfRootNumbers) {
  const FloatEnvironment standard;
  testing::Source random(11);
  for (int k = 0; k < 300; ++k) {
    const auto draw = [&] { return Rational(random.between(-9, 9), random.between(1, 4)); };
    const Rational m(random.between(2, 30)), a = draw(), b = draw(), c = draw(), d = draw(),
                                             f = draw();
    const Rational e = abs(f) * 6 + random.between(0, 3);
    const RootNumber r = sqrt(RootNumber(m));
    const RootNumber inner = RootNumber(e) + RootNumber(f) * r;
    const Surd s = sqrt(Surd(m)), inside = Surd(e) + Surd(f) * s;
    const RootNumber rolled = sqrt(inner);
    const RootNumber x =
        RootNumber(a) + RootNumber(b) * r + (RootNumber(c) + RootNumber(d) * r) * rolled;
    const Surd y = Surd(a) + Surd(b) * s + (Surd(c) + Surd(d) * s) * sqrt(inside);
    ASSERT_EQ(sign(x), sign(y)) << k;
    const Surd conjugate = Surd(a) + Surd(b) * s - (Surd(c) + Surd(d) * s) * sqrt(inside);
    const Surd u = Surd(a) + Surd(b) * s, v = Surd(c) + Surd(d) * s;
    ASSERT_EQ(sign(y * conjugate - (u * u - v * v * inside)), 0) << k;
  }
}

}  // namespace
}  // namespace minkref::of_surds
