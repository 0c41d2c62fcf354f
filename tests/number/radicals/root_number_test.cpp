// Numbers with square roots: laws of a field, signs, and zeros that only algebra tells.
#include "reference/number/radicals/root_number.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "reference/error.hpp"
#include "reference/number/radicals/polynomial.hpp"

namespace minkref::of_root_number {
namespace {

Rational fraction(std::mt19937& dice, int most = 9) {
  return Rational(static_cast<int>(dice() % (2U * static_cast<unsigned>(most) + 1)) - most,
                  1 + static_cast<int>(dice() % 5));
}

/// In a field with up to three roots, the later ones nested.
RootNumber random_number(std::mt19937& dice, unsigned roots) {
  RootNumber x = fraction(dice);
  for (unsigned k = 0; k < roots; ++k) {
    const RootNumber radicand = x * x + fraction(dice) * fraction(dice) + Rational(1 + k);
    if (sign(radicand) < 0) continue;
    x = RootNumber(fraction(dice)) + RootNumber(fraction(dice)) * sqrt(radicand);
  }
  return x;
}

TEST(RootNumber, KnowsItsSignWhereDoublesDoNot) {
  for (int seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(static_cast<unsigned>(seed));
    const RootNumber x = random_number(dice, 1 + dice() % 3);
    // A rational so near that doubles and 192 bits leave the sign open.
    const Rational near = x.enclosure(400).low();
    const MpfrInterval wide = (x - near).enclosure(2000);
    EXPECT_EQ(sign(x - near), wide.certain_sign());
    EXPECT_EQ(sign(x - x), 0);
    EXPECT_EQ(sign(-(x - near)), -wide.certain_sign());
  }
}

TEST(RootNumber, HasTheLawsOfAField) {
  for (int seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(static_cast<unsigned>(seed));
    const RootNumber x = random_number(dice, 2);
    const RootNumber y = RootNumber(fraction(dice)) * x * x + RootNumber(fraction(dice));
    EXPECT_EQ((x + y) * (x - y), x * x - y * y);
    EXPECT_EQ((x + y) - y, x);
    if (sign(y) != 0) {
      EXPECT_EQ(x / y * y, x);
    }
    if (sign(x) >= 0) {
      const RootNumber root = sqrt(x);
      EXPECT_EQ(root * root, x);
      EXPECT_GE(sign(root), 0);
    }
  }
}

TEST(RootNumber, SeesZerosOfRootsThatAreThereAlready) {
  const RootNumber two = sqrt(RootNumber(2));
  const auto three = RootField::with_root_of(RootNumber(3).in(two.field()));
  std::vector<Rational> unit(4);
  const RootNumber root_of_three = sqrt(RootNumber(3).in(two.field()));
  // The second root's field object is not `three`, so the sum must be refused, not guessed.
  EXPECT_THROW(root_of_three + sqrt(RootNumber(3)), std::logic_error);
  const RootNumber sum = two + root_of_three;
  // sqrt(5 + 2 sqrt(6)) = sqrt(2) + sqrt(3)
  const RootNumber product = two * root_of_three;
  const RootNumber nested = sqrt(RootNumber(5) + RootNumber(2) * product);
  EXPECT_EQ(sign(nested - sum), 0);
  EXPECT_EQ(sign(RootNumber(1) / (nested + sum) * sum - RootNumber(Rational(1, 2))), 0);
  EXPECT_THROW(RootNumber(1) / (nested - sum), std::domain_error);
  EXPECT_EQ(three->roots(), 2U);
}

TEST(RootNumber, OfRationalSquaresNeedsNoRoot) {
  EXPECT_EQ(sqrt(RootNumber(Rational(9, 4))).field()->roots(), 0U);
  EXPECT_EQ(sqrt(RootNumber(Rational(9, 4))), RootNumber(Rational(3, 2)));
  EXPECT_EQ(sign(sqrt(RootNumber(0))), 0);
  EXPECT_THROW(sqrt(RootNumber(-1)), std::domain_error);
  EXPECT_THROW(sqrt(sqrt(RootNumber(2)) - RootNumber(2)), std::domain_error);
}

TEST(RootNumber, RefusesMoreRootsThanEventsHave) {
  RootNumber x = sqrt(RootNumber(2));
  for (std::size_t k = 1; k < RootField::most_roots; ++k) x = sqrt(x + RootNumber(1));
  EXPECT_THROW(sqrt(x), LimitExceeded);
}

TEST(RootNumber, IsARootOfItsPolynomial) {
  for (int seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(static_cast<unsigned>(seed));
    const RootNumber x = random_number(dice, dice() % 4);
    const Polynomial p = x.polynomial();
    EXPECT_EQ(p.size(), (std::size_t{1} << x.field()->roots()) + 1);
    EXPECT_EQ(p.back(), 1);
    EXPECT_EQ(sign(value_at(p, x)), 0);
  }
}

}  // namespace
}  // namespace minkref::of_root_number
