// Signs from words, from doubles with a bound and from integers agree.
#include "reference/space/vertex_signs.hpp"

#include <gtest/gtest.h>

#include <random>

namespace minkref::of_vertex_signs {
namespace {

int sign_of(const std::vector<IntegerVector>& p) {
  return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]).sign();
}

/// Points on a small grid around a far one, all times a factor.
std::vector<IntegerVector> drawn(std::mt19937& dice, const Integer& factor, const Integer& far) {
  std::uniform_int_distribution<int> coordinate(-2, 2);
  std::vector<IntegerVector> points(4);
  for (IntegerVector& p : points) {
    for (Integer& c : p) c = factor * coordinate(dice) + far;
  }
  return points;
}

TEST(VertexSigns, AreThoseOfIntegers) {
  const Integer one = 1;
  const std::vector<std::pair<Integer, Integer>> scales = {{1, 0},
                                                           {1, one << 52},
                                                           {(one << 60) + 1, 0},
                                                           {1, one << 80},
                                                           {one << 2000, 7},
                                                           {(one << 20) + 1, one << 64},
                                                           {(one << 500) + 1, one << 900}};
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    for (const auto& [factor, far] : scales) {
      const std::vector<IntegerVector> points = drawn(dice, factor, far);
      const VertexSigns signs(points);
      EXPECT_EQ(signs.orientation(0, 1, 2, 3), sign_of(points));
      EXPECT_EQ(signs.orientation(0, 1, 1, 3), 0);
      const IntegerVector normal = cross(points[1] - points[0], points[2] - points[0]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(signs.turn(0, 1, 2, axis), normal[axis].sign());
      }
    }
  }
}

TEST(VertexSigns, BoxesHoldTheVertices) {
  const Integer one = 1;
  const std::vector<IntegerVector> points = {{(one << 70) + 1, -(one << 70) - 1, 3}, {0, 1, -1}};
  const VertexSigns signs(points);
  for (std::uint32_t v = 0; v < 2; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational exact(points[v][k]);
      EXPECT_LE(from_double(signs.box(v).low[k]), exact);
      EXPECT_GE(from_double(signs.box(v).high[k]), exact);
    }
  }
  EXPECT_EQ(signs.box(1).low[2], -1);
  const auto [low, high] = signs.enclosed(1, 3);
  EXPECT_LT(from_double(low), Rational(1, 3));
  EXPECT_GT(from_double(high), Rational(1, 3));
}

}  // namespace
}  // namespace minkref::of_vertex_signs
