// One piece of code written against the concept runs over all four models, in Eigen's types too.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "reference/number/eigen.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::of_scalar {
namespace {

struct Points {
  Rational coordinates[6];
};

/// The sign of a triangle's area, computed with the given arithmetic.
template <Scalar T>
int orientation(const Points& points, const Arithmetic<T>& arithmetic) {
  Vector2<T> p[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = {arithmetic(points.coordinates[2 * i]), arithmetic(points.coordinates[2 * i + 1])};
  }
  Matrix2<T> sides;
  sides << p[1] - p[0], p[2] - p[0];
  return sign(sides.determinant());
}

template <Scalar T>
class EveryScalar : public ::testing::Test {};
using Scalars = ::testing::Types<Rational, Interval, Mpfr, double>;
TYPED_TEST_SUITE(EveryScalar, Scalars);

TYPED_TEST(EveryScalar, DefaultsToZeroAndTakesIntegersExactly) {
  EXPECT_EQ(sign(TypeParam()), 0);
  EXPECT_EQ(sign(TypeParam(3) - TypeParam(2) - TypeParam(1)), 0);
  EXPECT_EQ(approximate(TypeParam(-7)), -7);
}

TYPED_TEST(EveryScalar, SmallIntegerGeometryIsExact) {
  MINKREF_SEEDED(random, 31);
  for (int i = 0; i < 2'000; ++i) {
    Points points;
    for (Rational& coordinate : points.coordinates) coordinate = random.between(-3, 3);
    const auto& c = points.coordinates;
    const Rational twice = (c[2] - c[0]) * (c[5] - c[1]) - (c[3] - c[1]) * (c[4] - c[0]);
    ASSERT_EQ(orientation(points, Arithmetic<TypeParam>()), twice.sign());
  }
}

TYPED_TEST(EveryScalar, VectorsAndMatricesWork) {
  const Arithmetic<TypeParam> number;
  const Vector2<TypeParam> a(number(Rational(1) / 2), number(3)),
      b(number(-2), number(Rational(1) / 4));
  EXPECT_EQ(approximate(a.dot(b)), -0.25);
  EXPECT_EQ(approximate((a + b).x()), -1.5);
  EXPECT_EQ(approximate((number(2) * a - b).y()), 5.75);
  EXPECT_EQ(approximate((-a).sum()), -3.5);
  Matrix2<TypeParam> m;
  m << a, b;
  EXPECT_EQ(approximate(m.determinant()), 6.125);
  EXPECT_EQ(approximate((m * a).x()), -5.75);
  EXPECT_EQ(approximate((m.transpose() * m).trace()), approximate(a.dot(a) + b.dot(b)));
  EXPECT_EQ(approximate(Matrix2<TypeParam>::Identity().determinant()), 1);
  EXPECT_EQ(approximate(Vector2<TypeParam>::Zero().sum()), 0);
}

TEST(ScalarNames, AreTheWordsOfTheCommandLine) {
  EXPECT_EQ(Arithmetic<Rational>().name(), "rational");
  EXPECT_EQ(Arithmetic<Interval>().name(), "interval");
  EXPECT_EQ(Arithmetic<double>().name(), "double");
  EXPECT_EQ(Arithmetic<Mpfr>(24).name(), "mpfr:24");
}

TEST(DoubleSign, NaNIsUndecided) {
  EXPECT_EQ(sign(-0.0), 0);
  EXPECT_EQ(sign(-1e-320), -1);
  EXPECT_EQ(sign(std::numeric_limits<double>::infinity()), 1);
  EXPECT_THROW(sign(std::nan("")), UndecidedSign);
}

TEST(MpfrInEigen, KeepsItsPrecisionThroughSumsAndProducts) {
  const Arithmetic<Mpfr> number(120);
  const Vector2<Mpfr> a(number(Rational(1) / 3), number(Rational(1) / 7));
  EXPECT_EQ(a.dot(a).precision(), 120);
  EXPECT_EQ((Matrix2<Mpfr>::Identity() * a).eval().x().precision(), 120);
  EXPECT_EQ((Matrix2<Mpfr>::Identity() * a).eval().x(), a.x());
}

/// Nearly collinear points: far apart, and off a line by less than the coordinates' last places.
TEST(SignsNearZero, IntervalIsRightOrSaysSoWhereDoublesAreWrong) {
  MINKREF_SEEDED(random, 32);
  int double_wrong = 0, interval_undecided = 0, mpfr_wrong = 0;
  constexpr int trials = 5'000;
  for (int i = 0; i < trials; ++i) {
    const Rational x = random.rational(40), y = random.rational(40), slope = random.rational(20);
    const Rational step = random.rational(30),
                   nudge = Rational(random.between(-1, 1)) / (Integer(1) << 90);
    const Points points{
        {x, y, x + step, y + slope * step, x + 3 * step, y + 3 * slope * step + nudge}};
    const int truth = orientation(points, Arithmetic<Rational>());
    double_wrong += orientation(points, Arithmetic<double>()) != truth;
    mpfr_wrong += orientation(points, Arithmetic<Mpfr>(53)) != truth;
    if (truth != 0) {
      ASSERT_EQ(orientation(points, Arithmetic<Mpfr>(2000)), truth);
    }
    try {
      ASSERT_EQ(orientation(points, Arithmetic<Interval>()), truth);
    } catch (const UndecidedSign&) {
      ++interval_undecided;
    }
  }
  EXPECT_EQ(mpfr_wrong, double_wrong);
  EXPECT_GT(double_wrong, trials / 20);
  EXPECT_GE(interval_undecided, double_wrong);
}

}  // namespace
}  // namespace minkref::of_scalar
