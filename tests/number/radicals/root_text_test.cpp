// Numbers with square roots as texts.
#include "reference/number/radicals/root_text.hpp"

#include <gtest/gtest.h>

namespace minkref::of_root_text {
namespace {

TEST(RootText, LeavesOutWhatIsZeroAndTakesSquaresOut) {
  EXPECT_EQ(expression(RootNumber(0)), "0");
  EXPECT_EQ(expression(RootNumber(Rational(-7, 3))), "-7/3");
  EXPECT_EQ(expression(sqrt(RootNumber(Rational(8)))), "2*sqrt(2)");
  EXPECT_EQ(expression(sqrt(RootNumber(Rational(1, 2)))), "1/2*sqrt(2)");
  EXPECT_EQ(expression(sqrt(RootNumber(Rational(9, 4)))), "3/2");
}

TEST(RootText, WritesRootsOfRoots) {
  const RootNumber root = sqrt(RootNumber(5));
  EXPECT_EQ(expression(RootNumber(2) - root), "2 - sqrt(5)");
  EXPECT_EQ(expression(sqrt(RootNumber(3) + root)), "sqrt(3 + sqrt(5))");
  EXPECT_EQ(expression(root * sqrt(RootNumber(3) + root) - RootNumber(1)),
            "-1 + sqrt(3 + sqrt(5))*sqrt(5)");
}

TEST(RootText, AddsNumbersOfSeveralFields) {
  RootTerms terms;
  terms.add(sqrt(RootNumber(2)));
  terms.add(sqrt(RootNumber(8)), Rational(1, 2));
  terms.add(RootNumber(3), 1, Rational(5));
  terms.add(RootNumber(-6), Rational(1, 2), Rational(5));
  EXPECT_EQ(terms.text(), "2*sqrt(2)");
  terms.add(RootNumber(1), -2, Rational(2));
  EXPECT_EQ(terms.text(), "0");
}

/// √2 √8 equals 4, though its name has two roots.
TEST(RootText, SeesWhatUnderARootIsRational) {
  const RootNumber two = sqrt(RootNumber(2));
  const RootNumber eight = sqrt(RootNumber(8).in(two.field()));
  EXPECT_EQ(expression(two * eight), "4");
  EXPECT_EQ(expression(sqrt(two * eight + RootNumber(5))), "3");
  EXPECT_EQ(expression(sqrt(two * eight - RootNumber(4)) + RootNumber(1)), "1");
}

/// √2 times √(2 x) simplifies to the root of a rational number.
TEST(RootText, ProductsOfRootsOfRationalsAreOne) {
  const RootNumber two = sqrt(RootNumber(2));
  RootTerms terms;
  terms.add(two, 1, Rational(8));
  EXPECT_EQ(terms.text(), "4");
}

}  // namespace
}  // namespace minkref::of_root_text
