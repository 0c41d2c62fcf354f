// Holes and components through the scales.
#include <gtest/gtest.h>

#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_topology {
namespace {

struct Numbers {
  std::size_t holes = 0, components = 0, vertices = 0;
};

Numbers numbers_at(const PolygonSet& P, const PolygonSet& Q, const Rational& s) {
  const Sum sum = minkowski_sum(P, Q, s);
  return {sum.holes, sum.components, sum.region.vertices()};
}

/// Differences from the static sums, between all arrangement events and at each of them.
std::string wrong_counts(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window) {
  const DynamicSum dynamic(P, Q, window);
  const ArrangementEvents& events = *dynamic.states().timeline().events;
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const auto& counts = timeline.counts;
  std::size_t state = 0;
  for (std::uint32_t i = 0; i <= events.groups(); ++i) {
    const Rational low = i > 0 ? events.exact(i - 1) : events.window().from.value_or(0);
    const Rational high =
        i < events.groups() ? events.exact(i) : events.window().to.value_or(2 * low + 1);
    while (state + 1 < counts.size() && counts[state + 1].interval <= i) ++state;
    const auto& mine = counts[state];
    const Numbers between = numbers_at(P, Q, (low + high) / 2);
    if (between.holes != mine.holes || between.components != mine.components) {
      return "between " + to_string(low) + " and " + to_string(high);
    }
    if (i == 0) continue;
    const bool begins = mine.interval == i;
    const Numbers at = numbers_at(P, Q, low);
    if (at.holes != (begins ? mine.holes_at : mine.holes) ||
        at.components != (begins ? mine.components_at : mine.components)) {
      return "at " + to_string(low);
    }
  }
  return "";
}

/// Whether the lives of the features add up to the counts, and the events tell every birth and
/// death.
std::string wrong_lives(const PolygonSet& P, const PolygonSet& Q) {
  const DynamicSum dynamic(P, Q, {});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const auto alive = [](const Feature& f, std::uint32_t interval) {
    return (!f.born || *f.born < interval) && (!f.died || *f.died >= interval);
  };
  for (const auto& count : timeline.counts) {
    std::size_t holes = 0, components = 0;
    for (std::size_t h = 1; h < timeline.holes.size(); ++h) {
      holes += alive(timeline.holes[h], count.interval);
    }
    for (const Feature& f : timeline.components) components += alive(f, count.interval);
    if (holes != count.holes || components != count.components) return "lives and counts differ";
  }
  for (const TopologyEvent& event : timeline.topology) {
    const auto& features = event.kind == FeatureKind::hole ? timeline.holes : timeline.components;
    for (const std::uint32_t f : event.before) {
      if (!alive(features[f], event.group)) return "an event of a feature that is not there before";
    }
    for (const std::uint32_t f : event.after) {
      if (!alive(features[f], event.group + 1)) return "... that is not there after";
    }
  }
  std::size_t told = 0, ends = 0;
  for (const auto* features : {&timeline.holes, &timeline.components}) {
    for (const Feature& f : *features) ends += f.born.has_value() + f.died.has_value();
  }
  for (const TopologyEvent& e : timeline.topology) {
    const std::size_t before = e.before.size(), after = e.after.size();
    told += std::max(before, after) - std::min(before, after);
  }
  return told == ends ? "" : "births and deaths without an event";
}

TEST(Topology, IsConstantBetweenEventsAndRightAtEach) {
  MINKREF_SEEDED(random, 420);
  expect_law(random, 60, [](const Case& c) { return wrong_counts(c.P, c.Q, {}); });
}

TEST(Topology, OfAWindowIsThatOfAllScales) {
  MINKREF_SEEDED(random, 421);
  expect_law(random, 30,
             [](const Case& c) { return wrong_counts(c.P, c.Q, {Rational(1, 2), Rational(2)}); });
}

TEST(Topology, LivesAddUp) {
  MINKREF_SEEDED(random, 422);
  expect_law(random, 60, [](const Case& c) { return wrong_lives(c.P, c.Q); });
}

/// The only topology event of holes at a scale.
TopologyEvent event_at(const DynamicSum& dynamic, const TopologyTimeline& timeline,
                       const Rational& s) {
  const auto at = dynamic.states().timeline().events->locate(s);
  EXPECT_TRUE(at.at);
  std::vector<TopologyEvent> found;
  for (const TopologyEvent& e : timeline.topology) {
    if (e.group == at.before && e.kind == FeatureKind::hole) found.push_back(e);
  }
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? TopologyEvent{} : found.front();
}

TEST(Topology, ATriangularHoleDiesWhereNoPairEventIs) {
  const PolygonSet P = region({{-3, -2}, {4, -1}, {1, 3}});
  const PolygonSet Q = region(rectangle(-40, -40, 40, 40), {{{0, 20}, {17, -11}, {-19, -9}}});
  const Rational s(541, 186);
  const DynamicSum dynamic(P, Q, {});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const TopologyEvent event = event_at(dynamic, timeline, s);
  EXPECT_EQ(event.change, TopologyEvent::Change::death);
  EXPECT_EQ(event.before, std::vector<std::uint32_t>{1});
  EXPECT_TRUE(event.after.empty());
  // The hole's three sides, each with the vertex of P that slides along it.
  ASSERT_EQ(timeline.boundary.size(), 1U);
  EXPECT_EQ(timeline.boundary[0].edges.size(), 3U);
  EXPECT_EQ(timeline.boundary[0].place, (Point{Rational(-59, 186), Rational(-107, 93)}));
  const Rational little = Rational(1) / Rational(Integer(1) << 60);
  EXPECT_EQ(numbers_at(P, Q, s - little).holes, 1U);
  EXPECT_EQ(numbers_at(P, Q, s).holes, 0U);
  EXPECT_EQ(numbers_at(P, Q, s + little).holes, 0U);
  EXPECT_EQ(wrong_counts(P, Q, {}), "");
}

TEST(Topology, ASlabCloses) {
  // A hole of width 2 under a square of side s: it closes to a segment at s = 2.
  const PolygonSet P = box(0, 0, 1, 1);
  const PolygonSet Q = region(rectangle(0, 0, 20, 9), {rectangle(3, 3, 13, 5)});
  const DynamicSum dynamic(P, Q, {});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const TopologyEvent event = event_at(dynamic, timeline, 2);
  EXPECT_EQ(event.change, TopologyEvent::Change::death);
  EXPECT_EQ(numbers_at(P, Q, 2).holes, 0U);
  EXPECT_EQ(wrong_counts(P, Q, {}), "");
}

TEST(Topology, AHoleSplitsAtAWaist) {
  // An hourglass: two 8 by 8 chambers and a channel between them, 2 wide.
  const Ring hourglass{{2, 2},   {10, 2},  {10, 5}, {14, 5}, {14, 2},  {22, 2},
                       {22, 10}, {14, 10}, {14, 7}, {10, 7}, {10, 10}, {2, 10}};
  const PolygonSet P = box(0, 0, 1, 1), Q = region(rectangle(0, 0, 24, 12), {hourglass});
  const DynamicSum dynamic(P, Q, {});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const TopologyEvent event = event_at(dynamic, timeline, 2);
  EXPECT_EQ(event.change, TopologyEvent::Change::split);
  EXPECT_EQ(event.before, std::vector<std::uint32_t>{1});
  EXPECT_EQ(event.after, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(wrong_counts(P, Q, {}), "");
}

TEST(Topology, TheLargestPartOfAHoleThatSplitsKeepsItsName) {
  // The unit square slides through a waist of width 2 between lobes of width 6 and of width 20 or
  // 4: both lobes are as high, so the narrower one dies first.
  for (const int width : {4, 20}) {
    const PolygonSet P = box(0, 0, 1, 1);
    const PolygonSet Q = region(rectangle(-9, -9, 60, 30), {Ring{{0, 0},
                                                                 {0, 9},
                                                                 {8, 9},
                                                                 {8, 5},
                                                                 {12, 5},
                                                                 {12, 9},
                                                                 {12 + width, 9},
                                                                 {12 + width, 0},
                                                                 {12, 0},
                                                                 {12, 3},
                                                                 {8, 3},
                                                                 {8, 0}}});
    const DynamicSum dynamic(P, Q, {});
    const TopologyTimeline timeline = topology_timeline(dynamic.states());
    const TopologyEvent event = event_at(dynamic, timeline, 2);
    ASSERT_EQ(event.change, TopologyEvent::Change::split);
    EXPECT_EQ(event.after, (std::vector<std::uint32_t>{1, 2}));
    const ArrangementEvents& events = *dynamic.states().timeline().events;
    // A lobe of width w and height 9 is gone at s = min(w, 9).
    EXPECT_EQ(events.exact(timeline.holes[1].died.value()), std::max(std::min(width, 9), 8));
    EXPECT_EQ(events.exact(timeline.holes[2].died.value()), std::min(std::min(width, 9), 8));
  }
}

TEST(Topology, AHoleTouchesItselfAtOneScaleOnly) {
  // P consists of two spikes, 10 apart; Q has a hole with a spike from below and a spike from
  // above. A copy of the upper spike passes a copy of the lower spike, tip at tip, at s = 1.
  const PolygonSet P{
      {Polygon{Ring{{-1, -2}, {1, -2}, {0, 0}}, {}}, Polygon{Ring{{10, 0}, {11, 2}, {9, 2}}, {}}}};
  const PolygonSet Q = region(rectangle(-200, -200, 200, 200), {Ring{{-100, -100},
                                                                     {-100, 100},
                                                                     {-11, 100},
                                                                     {-10, 0},
                                                                     {-9, 100},
                                                                     {100, 100},
                                                                     {100, -100},
                                                                     {1, -100},
                                                                     {0, 0},
                                                                     {-1, -100}}});
  const ScaleWindow window{Rational(1, 2), Rational(3, 2)};
  const DynamicSum dynamic(P, Q, window);
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  const TopologyEvent event = event_at(dynamic, timeline, 1);
  EXPECT_EQ(event.kind, FeatureKind::hole);
  EXPECT_EQ(event.change, TopologyEvent::Change::touch);
  EXPECT_EQ(event.before, std::vector<std::uint32_t>{1});
  EXPECT_EQ(event.after, std::vector<std::uint32_t>{1});
  EXPECT_EQ(event.at, 2U);
  EXPECT_EQ(event.place, (Point{0, 0}));
  EXPECT_EQ(wrong_counts(P, Q, window), "");
}

TEST(Topology, EventsCloserThanDoublesCanTellAreApart) {
  // Two square holes, one larger by 2^-70; the unit square fills them at scales 1 and 1 + 2^-70.
  const Rational more = 1 + Rational(Integer(1), Integer(1) << 70);
  const PolygonSet P = box(0, 0, 1, 1);
  const PolygonSet Q =
      region(rectangle(-9, -9, 9, 9),
             {rectangle(0, 0, 1, 1), Ring{{3, 0}, {3, more}, {3 + more, more}, {3 + more, 0}}});
  const DynamicSum dynamic(P, Q, {Rational(1, 2), Rational(3, 2)});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  ASSERT_EQ(timeline.topology.size(), 2U);
  const ArrangementEvents& events = *dynamic.states().timeline().events;
  EXPECT_EQ(events.exact(timeline.topology[0].group), 1);
  EXPECT_EQ(events.exact(timeline.topology[1].group), more);
  EXPECT_EQ(numbers_at(P, Q, (1 + more) / 2).holes, 1U);
}

TEST(Topology, ComponentsMerge) {
  // Squares with side s at distance 6: they touch along an edge if s + 1 = 6.
  const PolygonSet P = box(0, 0, 1, 1);
  const PolygonSet Q = together(box(0, 0, 1, 1), box(6, 0, 7, 1));
  const DynamicSum dynamic(P, Q, {});
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  ASSERT_EQ(timeline.components.size(), 2U);
  ASSERT_EQ(timeline.topology.size(), 1U);
  const TopologyEvent& event = timeline.topology.front();
  EXPECT_EQ(event.kind, FeatureKind::component);
  EXPECT_EQ(event.change, TopologyEvent::Change::merge);
  EXPECT_EQ(event.before, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(dynamic.states().timeline().events->exact(event.group), 5);
  EXPECT_EQ(wrong_counts(P, Q, {}), "");
}

TEST(Topology, AnIslandMergesWithTheShore) {
  // A component inside another component's hole: it grows until it touches.
  const PolygonSet P = box(0, 0, 1, 1);
  const PolygonSet Q =
      together(region(rectangle(0, 0, 30, 30), {rectangle(5, 5, 25, 25)}), box(14, 14, 16, 17));
  EXPECT_EQ(wrong_counts(P, Q, {}), "");
  EXPECT_EQ(wrong_lives(P, Q), "");
}

/// The only event of components from scale 1 to scale 3.
TopologyEvent event_of_components(const PolygonSet& P, const PolygonSet& Q) {
  const DynamicSum dynamic(P, Q, {Rational(1), Rational(3)});
  std::vector<TopologyEvent> found;
  for (const TopologyEvent& event : topology_timeline(dynamic.states()).topology) {
    if (event.kind == FeatureKind::component) found.push_back(event);
  }
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? TopologyEvent{} : found.front();
}

TEST(Topology, AnIslandThatFillsItsHoleAtOnceMerges) {
  // Island and hole are parallel: at s = 2 the boundary between them vanishes completely.
  const PolygonSet P = box(0, 0, 1, 1);
  const PolygonSet shore = region(rectangle(0, 0, 9, 9), {rectangle(2, 2, 7, 7)});
  const TopologyEvent one = event_of_components(P, together(shore, box(4, 4, 5, 5)));
  EXPECT_EQ(one.change, TopologyEvent::Change::merge);
  EXPECT_EQ(one.before, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(one.after, std::vector<std::uint32_t>{0});
  EXPECT_EQ(one.at, 1U);
  // With distant components around, the island merges with the right component.
  const PolygonSet far = together(box(-30, 0, -29, 9), together(shore, box(4, 4, 5, 5)));
  const TopologyEvent two = event_of_components(P, together(far, box(90, 0, 91, 9)));
  EXPECT_EQ(two.change, TopologyEvent::Change::merge);
  EXPECT_EQ(two.before.size(), 2U);
  EXPECT_EQ(two.at, 1U);
}

TEST(Topology, AMoatThatOpensAtOnceSplitsAnIslandOff) {
  // The moat is s wide and a little more, and Q as wide as 2: from s = 2 on it is open all around.
  const PolygonSet P =
      together(region(rectangle(-3, -3, 4, 4), {rectangle(-1, -1, 2, 2)}), box(0, 0, 1, 1));
  const TopologyEvent event = event_of_components(P, box(-1, -1, 1, 1));
  EXPECT_EQ(event.change, TopologyEvent::Change::split);
  EXPECT_EQ(event.before.size(), 1U);
  EXPECT_EQ(event.at, 1U);
  EXPECT_EQ(event.after.size(), 2U);
}

}  // namespace
}  // namespace minkref::testing::of_topology
