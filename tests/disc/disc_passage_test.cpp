// Discs that move: distances of segments, best ways by levels, passages. Laws: docs/paths.md.
#include "reference/disc/clearance/disc_passage.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "reference/disc/clearance/level_ways.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::of_disc_passage {
namespace {

Point drawn(std::mt19937& dice) {
  std::uniform_int_distribution<int> coordinate(-4, 4);
  const int x = coordinate(dice);
  return {x, Rational(coordinate(dice)) / 3};
}

Rational squared_gap(const ClosedSegment& first, const ClosedSegment& second,
                     const NearestPlaces& found) {
  const auto at = [](const ClosedSegment& segment, const Rational& t) {
    return Point{segment.a.x + t * (segment.b.x - segment.a.x),
                 segment.a.y + t * (segment.b.y - segment.a.y)};
  };
  const Direction way = from_to(at(first, found.t), at(second, found.u));
  return dot(way, way);
}

TEST(SegmentDistance, IsThatOfItsPlacesAndWithinTheDoubles) {
  const FloatEnvironment standard;
  const unsigned seed = 1812;
  std::cout << "seed " << seed << "\n";
  std::mt19937 dice(seed);
  for (int k = 0; k < 2000; ++k) {
    const ClosedSegment first{drawn(dice), drawn(dice)}, second{drawn(dice), drawn(dice)};
    const NearestPlaces found = nearest_places(first, second);
    EXPECT_EQ(squared_gap(first, second, found), found.squared);
    EXPECT_EQ(nearest_places(second, first).squared, found.squared);
    const Interval near = squared_distance(NearSegment(first), NearSegment(second));
    EXPECT_LE(Rational(near.lower()), found.squared);
    EXPECT_GE(Rational(near.upper()), found.squared);
  }
}

TEST(LevelWays, AreAsHighAsCanBeAndNameTheirLowestDoors) {
  // 0 - 1 - 2 - 3 - 4 and a lower way 0 - 5 - 4; 1 and 3 are at one level.
  const std::vector<std::vector<std::uint32_t>> joined{{1, 5}, {0, 2}, {1, 3}, {2, 4},
                                                       {3, 5}, {0, 4}, {}};
  const std::vector<std::uint32_t> levels{9, 4, 8, 4, 9, 3, 9};
  const LevelWays ways(joined, [&](std::uint32_t node) { return levels[node]; });
  const auto found = ways.find(0, 4);
  EXPECT_TRUE(found.is_connected);
  EXPECT_EQ(found.level, 4U);
  EXPECT_EQ(found.doors, (LevelWays::Numbers{1, 3}));
  EXPECT_EQ(ways.find(4, 0).doors, (LevelWays::Numbers{3, 1}));
  EXPECT_EQ(ways.find(0, 1).doors, LevelWays::Numbers{});
  EXPECT_EQ(ways.find(2, 2).level, 8U);
  EXPECT_FALSE(ways.find(0, 6).is_connected);
}

TEST(DiscRooms, TheDoorOfARoomIsTheNeck) {
  const PolygonSet room{{{{{-1, -1},
                           {9, -1},
                           {9, 3},
                           {8, 3},
                           {8, 0},
                           {0, 0},
                           {0, 8},
                           {8, 8},
                           {8, 5},
                           {9, 5},
                           {9, 9},
                           {-1, 9}},
                          {}}}};
  const DiscRooms rooms(room);
  const DiscPassage away = rooms.passage({4, 4}, std::nullopt);
  EXPECT_EQ(away.limit, DiscPassage::Limit::neck);
  ASSERT_EQ(away.necks.size(), 1U);
  const DiagramEvents& diagram = rooms.index().diagram();
  EXPECT_EQ(diagram.exact(diagram.events[away.necks[0]]).squared_radius, RootNumber(1));
  EXPECT_EQ(rooms.passage({4, 4}, Point{2, 2}).limit, DiscPassage::Limit::end);
  EXPECT_EQ(rooms.passage({20, 4}, std::nullopt).limit, DiscPassage::Limit::start);
  EXPECT_EQ(rooms.passage({-1, 4}, std::nullopt).limit, DiscPassage::Limit::apart);
}

}  // namespace
}  // namespace minkref::of_disc_passage
