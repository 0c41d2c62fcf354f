// Holes, components and events of the index are those of the dynamic sum, which steps through the
// arrangement and has no patches.
#include "reference/scalespace/feature_timeline.hpp"

#include <gtest/gtest.h>

#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/scalespace/scale_space_index.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing {
namespace {

std::string names(const std::vector<std::uint32_t>& features) {
  std::string text;
  for (const std::uint32_t f : features) text += " " + std::to_string(f);
  return text;
}

/// All that two timelines should agree on, as text. Places are compared where a feature vanishes or
/// appears: elsewhere a route is free to name one of several.
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
                    std::to_string(static_cast<int>(event.change)));
  }
  for (const TopologyEvent& event : timeline.topology) {
    if (!is_within(event.group)) continue;
    using Change = TopologyEvent::Change;
    const bool has_place = event.change == Change::birth || event.change == Change::death;
    lines.push_back(
        "topology " + to_string(scale(event.group)) + " " +
        std::to_string(static_cast<int>(event.kind)) +
        std::to_string(static_cast<int>(event.change)) + names(event.before) + " to" +
        names(event.after) + " parts " + std::to_string(event.at) +
        (has_place ? " at " + to_string(event.place.x) + "," + to_string(event.place.y) : ""));
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
  const ScaleSpaceIndex index(P, Q, window);
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

ScaleWindow some_window(const Case& c) {
  if (c.scale == 1) return {};
  if (c.scale == 2) return {Rational(1, 3), std::nullopt};
  return {c.scale / 2, c.scale * 3};
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

TEST(FeatureTimeline, PartsOfOneAreaThatTouchInTheirLeastPointHaveAnOrder) {
  PolygonSet Q = box(-100, -100, 100, 100);
  Q.polygons[0].holes.push_back({{0, 0}, {10, 10}, {24, 10}, {4, 0}, {24, -10}, {10, -10}});
  EXPECT_EQ(difference(segment_set({0, 0}, {-1, 0}), Q, {Rational(1, 2), Rational(20)}), "");
}

}  // namespace
}  // namespace minkref::testing
