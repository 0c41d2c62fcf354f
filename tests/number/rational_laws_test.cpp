// Rationals form an ordered field.
#include <gtest/gtest.h>

#include "reference/number/scalar.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_rational_laws {
namespace {

TEST(RationalLaws, Field) {
  MINKREF_SEEDED(random, 7);
  for (int i = 0; i < 20'000; ++i) {
    const Rational a = random.rational(), b = random.rational(), c = random.rational();
    ASSERT_EQ(a + b, b + a);
    ASSERT_EQ(a * b, b * a);
    ASSERT_EQ((a + b) + c, a + (b + c));
    ASSERT_EQ((a * b) * c, a * (b * c));
    ASSERT_EQ(a * (b + c), a * b + a * c);
    ASSERT_EQ(a + Rational(0), a);
    ASSERT_EQ(a * Rational(1), a);
    ASSERT_EQ(a + -a, 0);
    ASSERT_EQ(a - b, a + -b);
    if (b != 0) {
      ASSERT_EQ(a / b * b, a);
    }
  }
}

TEST(RationalLaws, SignIsMultiplicativeAndOrdersTheField) {
  MINKREF_SEEDED(random, 8);
  for (int i = 0; i < 20'000; ++i) {
    const Rational a = random.rational(), b = random.coin() ? random.rational() : Rational(-a);
    ASSERT_EQ(sign(a * b), sign(a) * sign(b));
    ASSERT_EQ(sign(-a), -sign(a));
    ASSERT_EQ(sign(a - b), a < b ? -1 : (a > b ? 1 : 0));
    if (sign(a) == sign(b)) {
      ASSERT_EQ(sign(a + b), sign(a));
    }
  }
}

}  // namespace
}  // namespace minkref::of_rational_laws
