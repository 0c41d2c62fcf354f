// The order between numbers from different fields.
#include "reference/number/radicals/root_order.hpp"

#include <gtest/gtest.h>

#include <random>

#include "reference/number/radicals/polynomial.hpp"

namespace minkref::of_root_order {
namespace {

RootNumber root(int n) { return sqrt(RootNumber(n)); }

TEST(RootOrder, FindsNumbersEqualThatFieldsNameDifferently) {
  const RootNumber two = root(2), three = sqrt(RootNumber(3).in(two.field()));
  const RootNumber nested = sqrt(RootNumber(5) + RootNumber(2) * root(6));
  EXPECT_EQ(compare(two + three, nested), 0);
  EXPECT_EQ(compare(nested, two + three), 0);
  EXPECT_EQ(compare(two * three, root(6)), 0);
  EXPECT_EQ(compare(root(8), two + two), 0);
  EXPECT_EQ(compare(RootNumber(3), root(9)), 0);
  // Conjugates share a polynomial, but are different.
  EXPECT_EQ(compare(RootNumber(1) - two, RootNumber(1) + root(2)), -1);
  EXPECT_EQ(compare(two - three, nested), -1);
}

TEST(RootOrder, TellsNumbersApartThatAreVeryNear) {
  for (int seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(static_cast<unsigned>(seed));
    const int m = 2 + static_cast<int>(dice() % 50), n = 2 + static_cast<int>(dice() % 50);
    const RootNumber a = root(m), b = sqrt(RootNumber(n).in(a.field()));
    const RootNumber x = a + b;
    // (x - near) + near in another field, with near nearer to x than 2^-300: equal; and near
    // itself.
    const Rational near = x.enclosure(300).low();
    EXPECT_EQ(compare(x, RootNumber(near)), sign(x - RootNumber(near)));
    const RootNumber other = sqrt(RootNumber(m + n) + RootNumber(2) * root(m * n));
    EXPECT_EQ(compare(x, other), 0);
    EXPECT_EQ(compare(x, other + RootNumber(Rational(1, Integer(1) << 900))), -1);
    EXPECT_EQ(compare(x + RootNumber(Rational(1, Integer(1) << 900)), other), 1);
  }
}

TEST(RootOrder, IsAnOrder) {
  for (int seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(static_cast<unsigned>(seed));
    std::vector<RootNumber> numbers;
    for (int k = 0; k < 4; ++k) {
      const RootNumber a = root(1 + static_cast<int>(dice() % 4));
      const RootNumber b = sqrt(RootNumber(1 + static_cast<int>(dice() % 4)).in(a.field()));
      numbers.push_back(a + b);
    }
    for (const RootNumber& x : numbers) {
      for (const RootNumber& y : numbers) {
        EXPECT_EQ(compare(x, y), -compare(y, x));
        for (const RootNumber& z : numbers) {
          if (compare(x, y) <= 0 && compare(y, z) <= 0) {
            EXPECT_LE(compare(x, z), 0);
          }
        }
      }
    }
  }
}

TEST(Polynomial, CountsRootsInHalfOpenIntervals) {
  // (X - 1)^2 (X + 2) X: 0, 1, -2
  const Polynomial p{0, 2, -3, 0, 1};
  EXPECT_EQ(count_roots(p, -3, 3), 3U);
  EXPECT_EQ(count_roots(p, -2, 1), 2U);
  EXPECT_EQ(count_roots(p, 0, 1), 1U);
  EXPECT_EQ(count_roots(p, 1, 3), 0U);
  EXPECT_EQ(without_multiple_roots(p), (Polynomial{0, -2, 1, 1}));
  EXPECT_EQ(common_divisor(p, {-1, 1}), (Polynomial{-1, 1}));
  EXPECT_EQ(common_divisor(p, {5, 1}), (Polynomial{1}));
  EXPECT_TRUE(common_divisor({}, {}).empty());
}

}  // namespace
}  // namespace minkref::of_root_order
