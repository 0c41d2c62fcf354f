// Odd-looking sets that are regular, closed and correctly given: they must be accepted.
#include <gtest/gtest.h>

#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_accepted {
namespace {

void expect_accepted(const PolygonSet& set) { EXPECT_NO_THROW(validate(set)) << text(set); }

TEST(Accepted, EmptySetPointAndSegment) {
  expect_accepted({});
  expect_accepted(point_set(1, 2));
  expect_accepted(segment_set({0, 0}, {1, 2}));
}

TEST(Accepted, CollinearVertices) {
  expect_accepted(region({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
  expect_accepted(region({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}}));
}

TEST(Accepted, HoleTouchesTheOuterRingVertexOnVertexAndVertexOnEdge) {
  expect_accepted(region(rectangle(0, 0, 4, 4), {{{0, 0}, {1, 2}, {2, 1}}}));
  expect_accepted(region(rectangle(0, 0, 4, 4), {{{0, 2}, {2, 1}, {2, 3}}}));
  expect_accepted(region(rectangle(0, 0, 4, 4), {{{2, 0}, {1, 2}, {2, 4}, {3, 2}}}));
  expect_accepted(region(rectangle(0, 0, 4, 4), {{{2, 0}, {0, 2}, {2, 4}, {4, 2}}}));
  // A reflex vertex of the outer ring on an edge of the hole.
  expect_accepted(
      region({{0, 0}, {8, 0}, {8, 8}, {5, 8}, {4, 4}, {3, 8}, {0, 8}}, {rectangle(2, 2, 6, 4)}));
}

TEST(Accepted, HolesTouchEachOther) {
  expect_accepted(
      region(rectangle(0, 0, 8, 8), {{{1, 1}, {1, 3}, {3, 2}}, {{3, 2}, {5, 3}, {5, 1}}}));
  expect_accepted(region(rectangle(0, 0, 8, 8), {rectangle(1, 1, 3, 3), {{3, 2}, {5, 3}, {5, 1}}}));
  expect_accepted(region(rectangle(0, 0, 8, 8), {rectangle(1, 1, 3, 3), rectangle(3, 3, 5, 5)}));
}

TEST(Accepted, OuterRingsTouchEachOther) {
  expect_accepted(together(box(0, 0, 1, 1), box(1, 1, 2, 2)));
  expect_accepted(together(box(0, 0, 2, 2), region({{2, 1}, {4, 0}, {4, 2}})));
}

TEST(Accepted, OuterRingInAHole) {
  const PolygonSet lake = region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 8, 8)});
  expect_accepted(together(lake, box(3, 3, 5, 5)));
  expect_accepted(together(box(3, 3, 5, 5), lake));
  // Its corners on the hole's edges.
  expect_accepted(together(lake, region({{1, 4}, {4, 1}, {8, 4}, {4, 8}})));
  expect_accepted(together(together(lake, region(rectangle(2, 2, 7, 7), {rectangle(3, 3, 6, 6)})),
                           box(4, 4, 5, 5)));
}

TEST(Accepted, ManyRingsThroughOnePoint) {
  PolygonSet fan;
  for (const auto& [a, b] : {std::pair{Point{3, -1}, Point{3, 1}},
                             {Point{1, 3}, Point{-1, 3}},
                             {Point{-3, 1}, Point{-3, -1}},
                             {Point{-1, -3}, Point{1, -3}}}) {
    fan = together(fan, region({{0, 0}, a, b}));
  }
  expect_accepted(fan);
}

TEST(Accepted, VerticesOfAHoleOnTheLineOfAnOuterEdgeThatDoesNotReachThem) {
  expect_accepted(region({{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 6}, {3, 6}, {3, 9}, {0, 9}},
                         {rectangle(3, 2, 6, 4)}));
}

TEST(Accepted, TheRandomOperandsOfThisFolder) {
  MINKREF_SEEDED(random, 1700);
  for (int i = 0; i < repetitions(150); ++i) expect_accepted(random_mesh_region(random, 4));
}

TEST(Accepted, HugeTinyAndUnlikeNumbers) {
  const Rational huge = Rational(Integer(1) << 4000), tiny = 1 / huge;
  expect_accepted(box(0, 0, huge, tiny));
  expect_accepted(region({{0, 0}, {huge, 0}, {huge, tiny}, {tiny, huge}}));
  expect_accepted(region(rectangle(0, 0, 1, 1), {rectangle(tiny, tiny, 1 - tiny, 1 - tiny)}));
}

}  // namespace
}  // namespace minkref::testing::of_accepted
