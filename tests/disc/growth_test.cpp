// Work grows nearly as its input where the answer does: turns of loops are counted, no time.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/disc/diagram/diagram_events.hpp"
#include "reference/disc/distance/static_offset.hpp"
#include "tests/counted_turns.hpp"
#include "tests/spiked_star.hpp"

namespace minkref::testing::of_disc_growth {
namespace {

/// Strictly convex: 2 n vertices on two parabolas.
PolygonSet lens(int n) {
  Ring ring;
  for (int k = 0; k < n; ++k) ring.push_back({2 * k - n, (2 * k - n) * (2 * k - n) - n * n});
  for (int k = 0; k < n; ++k) ring.push_back({n - 2 * k, n * n - (n - 2 * k) * (n - 2 * k)});
  return {{{ring, {}}}};
}

TEST(Growth, PatchesOfTheHullAskForNothing) {
  const PolygonSet small = lens(100), large = lens(400);
  const auto find = [](const PolygonSet& P) {
    BuildOptions options;
    options.threads = 1;
    (void)diagram_events(P, options);
  };
  // Boxes of steep edges poke through the lines of some neighbours.
  expect_growth([&] { find(small); }, [&] { find(large); }, 1.7);
}

/// A block with n x n triangular holes, all alike.
PolygonSet grater(int n) {
  std::vector<Ring> holes;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int x = 20 * i, y = 20 * j;
      holes.push_back({{x, y}, {x + 3, y + 9}, {x + 9, y + 4}});
    }
  }
  const int far = 20 * n;
  return {{{{{-20, -20}, {far, -20}, {far, far}, {-20, far}}, holes}}};
}

/// Comparisons of equal roots look each time: a sort asked for those of all pairs that it meets.
TEST(Growth, EventsAtOneRadiusAreToldFromEachOtherOnce) {
  const auto find = [](int n) { (void)diagram_events(grater(n), BuildOptions()); };
  expect_growth([&] { find(6); }, [&] { find(12); });
}

TEST(Growth, OffsetsCompareEachCurveWithTheEdgesNearIt) {
  const auto pairs = [](int vertices) {
    return static_cast<double>(static_offset(spiked_star(vertices), 25).counts.pairs);
  };
  const double before = pairs(200), after = pairs(800);
  EXPECT_LT(after, std::pow(4, 1.25) * before) << before << " pairs before";
}

}  // namespace
}  // namespace minkref::testing::of_disc_growth
