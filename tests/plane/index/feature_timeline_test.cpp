// The index has the same holes, components and events as the dynamic sum, which steps through the
// arrangement without patches.
#include "reference/plane/index/feature_timeline.hpp"

#include <gtest/gtest.h>

#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_feature_timeline {
namespace {

std::string names(const std::vector<std::uint32_t>& features) {
  std::string text;
  for (const std::uint32_t f : features) text += " " + std::to_string(f);
  return text;
}

std::string place(const Point& p) { return " at " + to_string(p.x) + "," + to_string(p.y); }

/// All that two timelines say, as text.
std::vector<std::string> account(const TopologyTimeline& timeline, const ScaleWindow& window,
                                 const std::function<Rational(std::uint32_t)>& scale) {
  const auto is_within = [&](std::uint32_t group) {
    const Rational s = scale(group);
    return (!window.from || s >= *window.from) && (!window.to || s <= *window.to);
  };
  std::vector<std::string> lines;
  for (const BoundaryEvent& event : timeline.boundary) {
    if (!is_within(event.group)) continue;
    lines.push_back("boundary " + to_string(scale(event.group)) + " " +
                    std::to_string(static_cast<int>(event.change)) + names(event.edges) +
                    place(event.place));
  }
  for (const TopologyEvent& event : timeline.topology) {
    if (!is_within(event.group)) continue;
    lines.push_back("topology " + to_string(scale(event.group)) + " " +
                    std::to_string(static_cast<int>(event.kind)) +
                    std::to_string(static_cast<int>(event.change)) + names(event.before) + " to" +
                    names(event.after) + " parts " + std::to_string(event.at) + place(event.place));
  }
  for (const auto* list : {&timeline.holes, &timeline.components}) {
    for (std::size_t k = 0; k < list->size(); ++k) {
      const Feature& f = (*list)[k];
      lines.push_back("feature " + std::to_string(k) + " " +
                      (f.born ? to_string(scale(*f.born)) : "-") + " " +
                      (f.died ? to_string(scale(*f.died)) : "-"));
    }
  }
  return lines;
}

std::string difference(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window) {
  DynamicSum dynamic(P, Q, window);
  const ScaleIndex index(P, Q, window);
  const auto expected = account(topology_timeline(dynamic.states()), window,
                                [&](std::uint32_t group) { return dynamic.states().scale(group); });
  const auto found =
      account(index.timeline(), window, [&](std::uint32_t event) { return index.event(event); });
  for (std::size_t k = 0; k < std::max(expected.size(), found.size()); ++k) {
    const std::string a = k < expected.size() ? expected[k] : "nothing",
                      b = k < found.size() ? found[k] : "nothing";
    if (a != b) return "line " + std::to_string(k) + ": expected " + a + ", found " + b;
  }
  return "";
}

/// The index's boundary events inside a window, as text.
std::vector<std::string> boundary_events(const ScaleIndex& index, const ScaleWindow& window) {
  std::vector<std::string> lines =
      account(index.timeline(), window, [&](std::uint32_t event) { return index.event(event); });
  std::erase_if(lines, [](const std::string& line) { return line[0] != 'b'; });
  return lines;
}

TEST(FeatureTimeline, IsThatOfTheDynamicSum) {
  MINKREF_SEEDED(random, 930);
  expect_law(random, 150, [](const Case& c) { return difference(c.P, c.Q, some_window(c)); });
}

TEST(FeatureTimeline, EventsAtTheEndsOfTheWindowAreInIt) {
  MINKREF_SEEDED(random, 931);
  expect_law(random, 40, [](const Case& c) -> std::string {
    DynamicSum dynamic(c.P, c.Q, {});
    const auto& groups = dynamic.states().groups();
    if (groups.size() < 2) return "";
    return difference(
        c.P, c.Q,
        {dynamic.states().scale(groups[0]), dynamic.states().scale(groups[groups.size() / 2])});
  });
}

TEST(FeatureTimeline, ParentsAndPlacesDoNotDependOnTheWindow) {
  MINKREF_SEEDED(random, 932);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleWindow narrow{Rational(3, 4), Rational(7, 4)};
    const auto in_all = boundary_events(ScaleIndex(c.P, c.Q, {}), narrow),
               in_part = boundary_events(ScaleIndex(c.P, c.Q, narrow), narrow);
    for (std::size_t k = 0; k < std::max(in_all.size(), in_part.size()); ++k) {
      const std::string a = k < in_all.size() ? in_all[k] : "nothing",
                        b = k < in_part.size() ? in_part[k] : "nothing";
      if (a != b) return "in all scales " + a + ", in a window " + b;
    }
    return "";
  });
}

/// Below and above, an edge joins the same two tracks; at the scale they are one point.
TEST(FeatureTimeline, AnEdgeThatTurnsRoundInAPointIsATouch) {
  const PolygonSet P{{{{{-1, -1}, {0, -1}, {0, 0}}, {}}, {{{1, 1}, {0, 2}, {0, 1}}, {}}}};
  const PolygonSet Q{{{{{0, 2}, {0, 0}, {1, 0}}, {}}, {{{-2, 1}, {-3, -1}, {-2, 0}}, {}}}};
  const ScaleWindow window{Rational(7, 5), Rational(8, 5)};
  EXPECT_EQ(difference(P, Q, window), "");
  const ScaleIndex index(P, Q, window);
  const TopologyTimeline timeline = index.timeline();
  ASSERT_EQ(timeline.boundary.size(), 1U);
  const BoundaryEvent& event = timeline.boundary[0];
  EXPECT_EQ(index.event(event.group), Rational(3, 2));
  EXPECT_EQ(event.change, BoundaryEvent::Change::touch);
  EXPECT_EQ(event.place, (Point{Rational(-3, 2), Rational(1, 2)}));
  EXPECT_EQ(event.edges.size(), 4U);
  EXPECT_TRUE(timeline.topology.empty());
}

/// Corners of two components slide along one line, on opposite sides.
TEST(FeatureTimeline, CornersThatPassEachOtherAreATouch) {
  const PolygonSet P{{{{{10, 0}, {11, 1}, {9, 1}}, {}}, {{{-10, 0}, {-11, -1}, {-9, -1}}, {}}}};
  const PolygonSet Q{{{{{-30, 0}, {-29, 1}, {-31, 1}}, {}}, {{{0, 0}, {-1, -1}, {1, -1}}, {}}}};
  const ScaleWindow window{Rational(7, 5), Rational(8, 5)};
  EXPECT_EQ(difference(P, Q, window), "");
  const TopologyTimeline timeline = ScaleIndex(P, Q, window).timeline();
  ASSERT_EQ(timeline.boundary.size(), 1U);
  EXPECT_EQ(timeline.boundary[0].change, BoundaryEvent::Change::touch);
  EXPECT_EQ(timeline.boundary[0].place, (Point{-15, 0}));
  EXPECT_TRUE(timeline.topology.empty());
}

TEST(FeatureTimeline, PartsOfOneAreaThatTouchInTheirLeastPointHaveAnOrder) {
  PolygonSet Q = box(-100, -100, 100, 100);
  Q.polygons[0].holes.push_back({{0, 0}, {10, 10}, {24, 10}, {4, 0}, {24, -10}, {10, -10}});
  EXPECT_EQ(difference(segment_set({0, 0}, {-1, 0}), Q, {Rational(1, 2), Rational(20)}), "");
}

}  // namespace
}  // namespace minkref::testing::of_feature_timeline
