// Sums under a factor for each axis: laws, and the update of convex ones against sums from scratch.
#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/plane/convex/dynamic_polygon_sum.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_plane_scaling {
namespace {

/// Ratios at which edges of small operands become parallel come up often among small factors.
PlaneScaling random_scaling(Source& random) {
  const auto factor = [&] {
    return Rational(Integer(random.between(1, 6)), Integer(random.between(1, 4)));
  };
  return {factor(), factor()};
}

PolygonSet sum(const PolygonSet& P, const PolygonSet& Q, const PlaneScaling& by) {
  return minkowski_sum(scaled(P, by), Q, 1).region;
}

PolygonSet canonical(const PolygonSet& set) { return canonicalize(set).region; }

/// Exchanges the axes; rings are turned as they have to run.
PolygonSet exchanged(const PolygonSet& set) {
  PolygonSet image = mapped(set, [](const Point& p) { return Point{p.y, p.x}; });
  orient(image);
  return image;
}

TEST(PlaneScaling, EqualFactorsAreTheUniformScale) {
  MINKREF_SEEDED(random, 900);
  expect_law(random, 60, [](const Case& c) {
    return unequal(minkowski_sum(c.P, c.Q, c.scale).region,
                   sum(c.P, c.Q, PlaneScaling{c.scale, c.scale}));
  });
}

TEST(PlaneScaling, ScalingBackGivesTheSumOfPAndTheOtherOperandScaledBack) {
  MINKREF_SEEDED(random, 901);
  expect_law(random, 60, [&](const Case& c) {
    const PlaneScaling by = random_scaling(random);
    const PlaneScaling back{Rational(1 / by.x), Rational(1 / by.y)};
    return unequal(minkowski_sum(c.P, scaled(c.Q, back), 1).region,
                   canonical(scaled(sum(c.P, c.Q, by), back)));
  });
}

TEST(PlaneScaling, TranslationOfPIsScaledToo) {
  MINKREF_SEEDED(random, 902);
  expect_law(random, 60, [&](const Case& c) {
    const PlaneScaling by = random_scaling(random);
    const Point p{random.rational(12), random.rational(12)};
    const Point q{random.rational(12), random.rational(12)};
    const Point moved{Rational(by.x * p.x + q.x), Rational(by.y * p.y + q.y)};
    return unequal(shifted(sum(c.P, c.Q, by), moved), sum(shifted(c.P, p), shifted(c.Q, q), by));
  });
}

TEST(PlaneScaling, ExchangeOfTheAxesExchangesTheFactors) {
  MINKREF_SEEDED(random, 903);
  expect_law(random, 60, [&](const Case& c) {
    const PlaneScaling by = random_scaling(random);
    return unequal(canonical(exchanged(sum(c.P, c.Q, by))),
                   sum(exchanged(c.P), exchanged(c.Q), PlaneScaling{by.y, by.x}));
  });
}

TEST(PlaneScaling, FactorsThatAreNotPositiveAreRefused) {
  const PolygonSet square = box(0, 0, 1, 1);
  for (const PlaneScaling& by : {PlaneScaling{0, 1}, PlaneScaling{1, -1}}) {
    EXPECT_THROW(sum(square, square, by), BadInput);
    EXPECT_THROW(DynamicPolygonSum(square, square, by), BadInput);
  }
}

/// Walks through scalings; the pairs and the sum have to be those from scratch after each.
std::string unlike_from_scratch(Source& random, const Case& c) {
  DynamicPolygonSum moving(c.P, c.Q, random_scaling(random));
  for (int step = 0; step < 12; ++step) {
    const PlaneScaling to = random_scaling(random);
    moving.update(to);
    const DynamicPolygonSum fresh(c.P, c.Q, to);
    if (moving.vertex_of_Q() != fresh.vertex_of_Q()) return "vertices of Q differ";
    if (moving.vertex_of_P() != fresh.vertex_of_P()) return "vertices of P differ";
    const std::string fault = unequal(sum(c.P, c.Q, to), moving.region());
    if (!fault.empty()) return to_string(to.x) + "," + to_string(to.y) + ": " + fault;
  }
  return "";
}

TEST(DynamicPolygonSum, IsTheStaticSumAfterEveryUpdate) {
  MINKREF_SEEDED(random, 904);
  expect_law(random, 40, convex_polygons(9, 9),
             [&](const Case& c) { return unlike_from_scratch(random, c); });
}

TEST(DynamicPolygonSum, IsTheStaticSumWhereEdgesBecomeParallel) {
  MINKREF_SEEDED(random, 905);
  expect_law(random, 60, convex_polygons(7, 2),
             [&](const Case& c) { return unlike_from_scratch(random, c); });
}

TEST(DynamicPolygonSum, UniformScalingMakesNoErrors) {
  MINKREF_SEEDED(random, 906);
  expect_law(random, 40, convex_polygons(), [](const Case& c) -> std::string {
    DynamicPolygonSum moving(c.P, c.Q, {1, 1});
    const PolygonUpdateCounts counts = moving.update({c.scale, c.scale});
    if (counts.ev_errors + counts.ve_errors + counts.descent_steps != 0) return "errors";
    return unequal(minkowski_sum(c.P, c.Q, c.scale).region, moving.region());
  });
}

TEST(DynamicPolygonSum, AnEdgeThatPassesAnotherIsOneErrorOfEach) {
  // The edge (-1, 1) of P passes the edge (-2, 3) of Q as the ratio goes over 3/2.
  const PolygonSet P = region({{0, 0}, {1, 0}, {0, 1}});
  const PolygonSet Q = region({{0, 0}, {2, 0}, {0, 3}});
  DynamicPolygonSum moving(P, Q, {1, 1});
  const PolygonUpdateCounts counts = moving.update({1, 2});
  EXPECT_EQ(counts.ev_errors, 1U);
  EXPECT_EQ(counts.ve_errors, 1U);
  EXPECT_EQ(counts.descent_steps, 2U);
  EXPECT_EQ(moving.region(), sum(P, Q, PlaneScaling{1, 2}));
}

TEST(DynamicPolygonSum, OperandsThatAreNotConvexAreRefused) {
  const PolygonSet square = box(0, 0, 1, 1);
  const PolygonSet dented = region({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  const PolygonSet holed = region(rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2)});
  for (const PolygonSet& bad : {dented, holed, point_set(1, 2), segment_set({0, 0}, {1, 1}),
                                PolygonSet{}, together(square, box(2, 2, 3, 3))}) {
    EXPECT_THROW(DynamicPolygonSum(bad, square, PlaneScaling{}), BadInput) << text(bad);
    EXPECT_THROW(DynamicPolygonSum(square, bad, PlaneScaling{}), BadInput) << text(bad);
    EXPECT_FALSE(is_convex(bad)) << text(bad);
  }
}

}  // namespace
}  // namespace minkref::testing::of_plane_scaling
