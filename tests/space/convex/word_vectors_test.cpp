// Words and integers of any length give the same signs, and the same surfaces.
#include "reference/space/word_vectors.hpp"

#include <gtest/gtest.h>

#include <random>

#include "reference/space/area_vector.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_word_vectors {
namespace {

using bodies::box;
using bodies::for_each_seed;
using bodies::random_body;
using bodies::random_scaling;

constexpr std::int64_t most = (std::int64_t{1} << most_word_bits) - 1;

/// Short points, long points, or points at the limits: their products tie, or doubles cannot
/// decide.
WordVector random_point(std::mt19937_64& dice) {
  const std::int64_t size = std::array<std::int64_t, 3>{2, 1 << 20, most}[dice() % 3];
  std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
  WordVector result{coordinate(dice), coordinate(dice), coordinate(dice)};
  if (dice() % 4 == 0) result[dice() % 3] = dice() % 2 == 0 ? most : -most;
  return result;
}

WideVector times(std::int64_t factor, const WideVector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

int sign_of(int compared) { return (compared > 0) - (compared < 0); }

TEST(WordVectors, HaveTheSignsOfIntegers) {
  for (unsigned seed = 1; seed <= 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 dice(seed);
    const std::vector<WordVector> points{random_point(dice), random_point(dice), random_point(dice),
                                         random_point(dice)};
    std::vector<IntegerVector> integers;
    for (const WordVector& p : points) integers.push_back(to_integers(p));
    const WideVector a = area_vector(points, {0, 1, 2});
    const IntegerVector exact_a = area_vector(integers, {0, 1, 2});
    ASSERT_EQ(to_integers(a), exact_a);
    // Vectors nearly parallel to a, parallel to a, or arbitrary.
    WideVector b = area_vector(points, {0, 1, 3});
    if (dice() % 3 == 0) {
      b = a;
      b[dice() % 3] += static_cast<int>(dice() % 3) - 1;
    }
    const WordVector d = points[1] - points[0], e = points[3] - points[2];
    for (const WordVector& along : {d, e}) {
      EXPECT_EQ(dot_sign(a, along), dot_sign(exact_a, to_integers(along)));
      EXPECT_EQ(turn_sign(a, b, along), turn_sign(exact_a, to_integers(b), to_integers(along)));
    }
    if (is_zero(a) || is_zero(b)) continue;
    const IntegerVector exact_b = to_integers(b);
    EXPECT_EQ(sign_of(compare(direction(a), direction(b))),
              sign_of(compare(direction(exact_a), direction(exact_b))));
  }
}

TEST(WordVectors, OfOneDirectionCompareEqualAndNoOthers) {
  for (unsigned seed = 1; seed <= 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 dice(seed);
    const WordVector p = random_point(dice), q = random_point(dice);
    const WideVector a = cross(WordVector{p[0] / 4096, p[1] / 4096, p[2] / 4096},
                               WordVector{q[0] / 4096, q[1] / 4096, q[2] / 4096});
    if (is_zero(a)) continue;
    EXPECT_EQ(compare(direction(times(3, a)), direction(times(5, a))), 0);
    EXPECT_NE(compare(direction(a), direction(times(-1, a))), 0);
    WideVector beside = times(3, a);
    beside[0] += 1;
    const WideVector five = times(5, a);
    const bool parallel = is_zero(cross(to_integers(beside), to_integers(five)));
    EXPECT_EQ(compare(direction(beside), direction(five)) == 0, parallel);
    EXPECT_EQ(sign_of(compare(direction(beside), direction(five))),
              -sign_of(compare(direction(five), direction(beside))));
  }
}

TEST(WordVectors, HoldCoordinatesUpToTheirLimitOnly) {
  const Integer limit = Integer(1) << most_word_bits;
  EXPECT_TRUE(in_words(std::vector<IntegerVector>{{limit - 1, 1 - limit, 0}}));
  EXPECT_FALSE(in_words(std::vector<IntegerVector>{{0, limit, 0}}));
  EXPECT_FALSE(in_words(std::vector<IntegerVector>{{0, 0, -limit}}));
}

/// Far from the origin the coordinates of the sum need more than words.
TEST(ConvexSum, IsTheSameSurfaceInWordsAndInIntegers) {
  for_each_seed(40, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    const Rational far = Integer(1) << 70;
    const ConvexSum near = bodies::sum(P, Q, s),
                    moved = bodies::sum(P, translated(Q, {far, -far, far}), s);
    EXPECT_EQ(moved.surface, translated(near.surface, {far, -far, far}));
    EXPECT_EQ(moved.facet_parents, near.facet_parents);
    EXPECT_EQ(moved.vertex_parents, near.vertex_parents);
  });
}

/// More corners than vector areas in words allow.
TEST(ConvexSum, OfAPrismWithAThousandSidesAndABoxHasAFacetForEachDirection) {
  Polyhedron prism;
  Face bottom, top;
  constexpr int sides = 1000;
  for (int k = 0; k < sides; ++k) {
    const int x = 2 * k - sides + 1;
    prism.vertices.push_back(bodies::at(x, x * x, 0));
    prism.vertices.push_back(bodies::at(x, x * x, 7));
    const auto at = static_cast<std::uint32_t>(2 * k),
               next = static_cast<std::uint32_t>(2 * ((k + 1) % sides));
    bottom.insert(bottom.begin(), at);
    top.push_back(at + 1);
    prism.faces.push_back({at, next, next + 1, at + 1});
  }
  prism.faces.push_back(bottom);
  prism.faces.push_back(top);
  const ConvexSum sum = bodies::sum(prism, box(1, 2, 3));
  // All walls of the prism, and the box's two walls across x: the box's other walls are parallel to
  // prism walls.
  EXPECT_EQ(sum.surface.faces.size(), sides + 2U + 2U);
  const Polyhedron canonical = ConvexPolyhedron(sum.surface).surface();
  EXPECT_EQ(canonical, sum.surface);
}

}  // namespace
}  // namespace minkref::of_word_vectors
