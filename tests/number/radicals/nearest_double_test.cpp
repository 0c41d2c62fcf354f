// The doubles written for exact numbers.
#include "reference/number/radicals/nearest_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace minkref::of_nearest_double {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// a + b √2, or the small rest after subtracting a close rational.
RootNumber random_difference(std::mt19937& dice) {
  const auto fraction = [&] { return Rational(static_cast<int>(dice() % 2001) - 1000, 7); };
  const RootNumber x = RootNumber(fraction()) + RootNumber(fraction()) * sqrt(RootNumber(2));
  const Rational near = x.enclosure(static_cast<long>(dice() % 900) + 60).low();
  return dice() % 2 == 0 ? x : x - RootNumber(near);
}

void expect_nearest(const RootNumber& x) {
  const double found = nearest_double(x);
  const Rational exact = from_double(found);
  const auto middle = [&](double other) { return Rational((exact + from_double(other)) / 2); };
  EXPECT_GE(sign(x - RootNumber(middle(std::nextafter(found, -infinity)))), 0);
  EXPECT_LE(sign(x - RootNumber(middle(std::nextafter(found, infinity)))), 0);
  const auto [low, high] = enclose(x);
  EXPECT_TRUE(high == low || high == std::nextafter(low, infinity));
  EXPECT_EQ(sign(x - RootNumber(from_double(low))), low == high ? 0 : 1);
  EXPECT_LE(sign(x - RootNumber(from_double(high))), 0);
  EXPECT_TRUE(found == low || found == high);
}

TEST(NearestDouble, IsNearerThanItsNeighbours) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    ASSERT_NO_FATAL_FAILURE(expect_nearest(random_difference(dice)));
  }
}

/// No precision tells on which side of such numbers an interval lies.
TEST(NearestDouble, IsDecidedExactlyWhereBitsNeverTell) {
  const RootNumber root = sqrt(RootNumber(2));
  const RootNumber other = sqrt(RootNumber(3) + RootNumber(2) * root);  // 1 + √2
  const auto hidden = [&](const Rational& value) {
    return RootNumber(Rational(value - 1)) + other - root;
  };
  const Rational unit = from_double(0x1p-52);
  EXPECT_EQ(nearest_double(hidden(1 + unit / 2)), 1.0);  // a tie, to the even one
  EXPECT_EQ(nearest_double(hidden(1 + 3 * unit / 2)), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(hidden(0)), 0.0);
  EXPECT_FALSE(std::signbit(nearest_double(-hidden(0))));
  EXPECT_EQ(enclose(hidden(0.75)), (Enclosure{0.75, 0.75}));
  EXPECT_EQ(nearest_double(root_of(hidden(Rational(9, 4)))), 1.5);
  EXPECT_EQ(enclose(root_of(hidden(Rational(9, 4)))), (Enclosure{1.5, 1.5}));
  EXPECT_EQ(enclose(root_of(hidden(0))), (Enclosure{0, 0}));
}

TEST(NearestDouble, EndsBeyondDoubles) {
  const Rational great(Integer(1) << 2000U);
  const RootNumber root = sqrt(RootNumber(2));
  EXPECT_EQ(nearest_double(RootNumber(great) * root), infinity);
  EXPECT_EQ(nearest_double(RootNumber(Rational(-great)) * root), -infinity);
  EXPECT_EQ(enclose(RootNumber(great) * root),
            (Enclosure{std::numeric_limits<double>::max(), infinity}));
  EXPECT_EQ(nearest_double(RootNumber(Rational(1 / great)) * root), 0.0);
  EXPECT_EQ(enclose(RootNumber(Rational(1 / great)) * root), (Enclosure{0, 0x1p-1074}));
}

TEST(NearestDouble, TwoDoublesTellAHundredBits) {
  for (int value = 0; value < 200; ++value) {
    SCOPED_TRACE(value);
    const RootNumber square{Rational(value, 7)};
    const auto [high, low] = two_doubles(root_of(square));
    EXPECT_EQ(high, nearest_double(root_of(square)));
    const Rational sum = from_double(high) + from_double(low), off = sum * from_double(0x1p-100);
    EXPECT_LE((sum - off) * (sum - off), square.coefficients()[0]);
    EXPECT_GE((sum + off) * (sum + off), square.coefficients()[0]);
  }
}

/// All four quarters, and both sides of the half axes.
TEST(MpfrInterval, HoldsAngles) {
  constexpr long bits = 100;
  for (int k = 0; k < 64; ++k) {
    const double angle = -3.1 + k * 6.2 / 63;
    const double x = 3 * std::cos(angle), y = 3 * std::sin(angle);
    const MpfrInterval found =
        atan2(MpfrInterval(from_double(y), bits), MpfrInterval(from_double(x), bits));
    EXPECT_NEAR(found.nearest().lower, std::atan2(y, x), 1e-15);
    EXPECT_NEAR(found.nearest().upper, std::atan2(y, x), 1e-15);
  }
  const MpfrInterval zero(0, bits), one(1, bits), third(Rational(1, 3), bits);
  EXPECT_EQ(atan2(zero, one).outwards(), (Enclosure{0, 0}));
  EXPECT_EQ(atan2(zero, -one).outwards(), (Enclosure{-4, 4}));
  EXPECT_EQ((one / (third - third)).outwards(), (Enclosure{-infinity, infinity}));
}

}  // namespace
}  // namespace minkref::of_nearest_double
