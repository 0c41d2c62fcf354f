// The Appendix's program, with all sentences corrected and exact numbers: the exact sum at every
// radius, the exact pair events.
#include "reference/paper/disc/disc_update.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "reference/disc/pairs/pair_events.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_disc_update {
namespace {

DiscUpdate::Options corrected(const std::string& arithmetic = "rational") {
  return {1, arithmetic, corrected_appendix(), 0};
}

/// Squared radii: rational ones from P's events, alternating with random ones.
std::vector<Rational> squared_radii(const PolygonSet& P, std::size_t most,
                                    testing::Source& random) {
  std::vector<Rational> of_events, all;
  const DiscPairEvents found = disc_pair_events(P);
  for (const DiscPairEvent& event : found.events) {
    const RootNumber square = found.squared_radius(event);
    if (square.field()->roots() == 0) of_events.push_back(square.coefficients()[0]);
  }
  for (std::size_t k = 0; k < most; ++k) {
    const bool at_event = k % 2 == 0 && !of_events.empty();
    all.push_back(at_event ? of_events[random.below(of_events.size())]
                           : Rational(1 + static_cast<int>(random.below(400)), 7));
  }
  return all;
}

void expect_exact(const PolygonSet& P, std::size_t radii, testing::Source& random,
                  const Rational& unit = 1) {
  DiscUpdate::Options options = corrected();
  options.squared_unit = unit;
  const auto update = DiscUpdate::make(P, unit, options);
  for (const Rational& square : squared_radii(P, radii, random)) {
    SCOPED_TRACE("squared radius " + to_string(square));
    update->move_to(square);
    const OffsetRegion exact = offset_region(P, square);
    const DiscAnswer answer = update->answer();
    ASSERT_EQ(canonical_json(answer, *update), canonical_json(exact));
    ASSERT_EQ(answer.components, exact.components.size());
    ASSERT_EQ(answer.holes, exact.holes);
  }
}

Ring box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Ring clockwise(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(DiscUpdate, IsExactForAFrameWithAnIsland) {
  testing::Source random(1);
  expect_exact({{{box(0, 0, 20, 20), {clockwise(box(2, 2, 18, 18))}}, {box(7, 7, 9, 11), {}}}}, 24,
               random);
}

TEST(DiscUpdate, IsExactForAPointASegmentAndNothing) {
  testing::Source random(2);
  expect_exact({{{{{1, 2}}, {}}}}, 3, random);
  expect_exact({{{{{0, 0}, {6, 8}}, {}}}}, 6, random);
  expect_exact({}, 2, random);
}

TEST(DiscUpdate, IsExactForAnyDiscAtScaleOne) {
  testing::Source random(3);
  const PolygonSet P{{{box(0, 0, 9, 9), {clockwise(box(2, 3, 7, 5))}}}};
  for (const Rational& unit : {Rational(2), Rational(9, 4), Rational(1, 3)}) {
    expect_exact(P, 8, random, unit);
  }
}

/// Equidistant walls, turned by a Pythagorean angle: flat ridges, ties, rational lengths.
TEST(DiscUpdate, IsExactForParallelWallsAndTurnedOnes) {
  testing::Source random(4);
  const PolygonSet comb{{{{{0, 0},
                           {11, 0},
                           {11, 6},
                           {9, 6},
                           {9, 2},
                           {7, 2},
                           {7, 6},
                           {4, 6},
                           {4, 2},
                           {2, 2},
                           {2, 6},
                           {0, 6}},
                          {}}}};
  const PolygonSet walls{{{box(0, 0, 1, 3), {}}, {box(3, 1, 4, 9), {}}, {box(6, 0, 9, 2), {}}}};
  for (const PolygonSet& P : {comb, walls}) {
    ASSERT_NO_FATAL_FAILURE(expect_exact(P, 8, random));
    const auto turned_set = testing::mapped(P, [](const Point& p) {
      return Point{Rational((3 * p.x - 4 * p.y) / 5), Rational((4 * p.x + 3 * p.y) / 5)};
    });
    ASSERT_NO_FATAL_FAILURE(expect_exact(turned_set, 8, random));
    const auto slanted = testing::mapped(
        P, [](const Point& p) { return Point{Rational(2 * p.x - p.y), Rational(p.x + 2 * p.y)}; });
    ASSERT_NO_FATAL_FAILURE(expect_exact(slanted, 4, random));
  }
}

TEST(DiscUpdate, IsExactForSetsThatAreAlmostDegenerate) {
  for (unsigned seed = 0; seed < testing::repetitions(12U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::shaken(random, testing::random_mesh_region(random, 2), 40);
    if (!testing::is_valid(P)) continue;
    ASSERT_NO_FATAL_FAILURE(expect_exact(P, 4, random));
  }
}

struct OfPair {
  std::vector<DiscUpdate::Event> found;
  std::vector<DiscPairEvent> exact;
};

/// Compares a pair's array with the exact search: equal radii, equal point counts between radii.
void expect_events(const OfPair& pair) {
  std::size_t next = 0;
  int points = 0;
  for (const auto& event : pair.found) points += event.insertion ? 0 : 1;
  for (const auto& event : pair.found) points -= event.insertion ? 1 : 0;
  // More ends than beginnings: the surplus exists from radius 0 on.
  points = std::max(points, 0);
  for (const DiscPairEvent& exact : pair.exact) {
    ASSERT_EQ(points, exact.before);
    std::size_t here = 0;
    for (; next < pair.found.size(); ++next, ++here) {
      const auto& event = pair.found[next];
      const Interval square = Interval(event.low, event.high) * Interval(event.low, event.high);
      if (square.lower() > exact.squared_radius.upper()) break;
      ASSERT_GE(square.upper(), exact.squared_radius.lower());
      points += event.insertion ? 1 : -1;
    }
    ASSERT_GT(here, 0U);
    ASSERT_EQ(points, exact.after);
  }
  ASSERT_EQ(next, pair.found.size());
}

TEST(DiscUpdate, HasTheEventsOfTheExactSearch) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_region(random, 2);
    const auto update = DiscUpdate::make(P, 1, corrected());
    std::map<std::pair<std::uint32_t, std::uint32_t>, OfPair> pairs;
    for (const auto& event : update->events()) pairs[{event.a, event.b}].found.push_back(event);
    for (const auto& event : disc_pair_events(P).events) {
      pairs[{event.a, event.b}].exact.push_back(event);
    }
    for (const auto& [names, pair] : pairs) {
      SCOPED_TRACE("features " + std::to_string(names.first) + ", " + std::to_string(names.second));
      ASSERT_NO_FATAL_FAILURE(expect_events(pair));
    }
  }
}

TEST(DiscUpdate, StepsThereAndBack) {
  testing::Source random(5);
  const PolygonSet P = testing::random_region(random, 2);
  for (const std::string arithmetic : {"rational", "double", "mpfr:100"}) {
    const auto update = DiscUpdate::make(P, 1, corrected(arithmetic));
    const std::string first = canonical_json(update->answer(), *update);
    const auto there = update->move_to(30), back = update->move_to(1);
    EXPECT_EQ(there.insertions, back.deletions);
    EXPECT_EQ(there.deletions, back.insertions);
    EXPECT_EQ(canonical_json(update->answer(), *update), first);
  }
}

/// In exact numbers `solve` changes nothing. Parallel segments left out cost events, no sum:
/// adjacent curves meet both segments at the ends of the common stretch. Every remaining sentence,
/// as printed, loses a sum.
TEST(DiscUpdate, LosesSumsBySentencesAsPrinted) {
  const std::map<std::string, std::pair<std::string, bool>> others{
      {"rejected", {"printed", true}},   {"number", {"printed", true}},
      {"parallel", {"left-out", false}}, {"solve", {"printed", false}},
      {"radical", {"printed", true}},    {"middle", {"left-out", true}},
      {"height", {"added", true}},       {"line", {"printed", true}},
      {"normal", {"from-origin", true}}, {"points", {"polygon", true}}};
  const PolygonSet ring{{{box(0, 0, 20, 20), {clockwise(box(2, 2, 18, 18))}},
                         {{{6, 7}, {12, 8}, {9, 9}, {8, 13}}, {}}}};
  const PolygonSet tips{{{{{0, 4}, {4, 6}, {0, 8}}, {}}, {{{14, 4}, {14, 8}, {10, 7}}, {}}}};
  const PolygonSet street{{{box(0, 0, 1, 3), {}}, {box(3, 1, 4, 9), {}}}};
  ASSERT_EQ(others.size(), appendix_reading_names().size());
  for (const auto& [name, choice] : others) {
    SCOPED_TRACE(name);
    DiscUpdate::Options options = corrected();
    options.squared_unit = Rational(9, 4);
    set_reading(options.readings, name, choice.first);
    bool is_lost = false;
    for (const PolygonSet& P : {ring, tips, street}) {
      const auto update = DiscUpdate::make(P, 1, options);
      for (const int square : {1, 4, 9, 10, 16, 49, 144}) {
        update->move_to(square);
        is_lost = is_lost || canonical_json(update->answer(), *update) !=
                                 canonical_json(offset_region(P, square));
      }
    }
    EXPECT_EQ(is_lost, choice.second);
  }
}

TEST(DiscUpdate, RefusesWrongRadiiArithmeticsAndReadings) {
  const PolygonSet P{{{box(0, 0, 1, 1), {}}}};
  EXPECT_THROW(DiscUpdate::make(P, 0, corrected()), BadInput);
  EXPECT_THROW(DiscUpdate::make(P, 1, corrected("interval")), BadInput);
  EXPECT_THROW(DiscUpdate::make(P, 1, corrected("mpfr:x")), BadInput);
  AppendixReadings readings;
  EXPECT_THROW(set_reading(readings, "radical", "right"), BadInput);
  EXPECT_THROW(set_reading(readings, "order", "kept"), BadInput);
  EXPECT_THROW(DiscUpdate::make(P, 1, corrected())->move_to(-1), BadInput);
}

TEST(DiscUpdate, IsExactForRandomRegionsAtEventsAndBetween) {
  for (unsigned seed = 0; seed < testing::repetitions(90U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_region(random, 2);
    ASSERT_NO_FATAL_FAILURE(expect_exact(P, 6, random));
  }
}

TEST(DiscUpdate, IsExactForGridsAtEventsAndBetween) {
  for (unsigned seed = 0; seed < testing::repetitions(90U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 2);
    ASSERT_NO_FATAL_FAILURE(expect_exact(P, 6, random));
  }
}

}  // namespace
}  // namespace minkref::of_disc_update
