// The dynamic sum, stepped up and down through its window's events, against the static sum and
// against the timeline of holes and components.
#include <algorithm>

#include "reference/paper/trials/from_scratch.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {

const Bounds bounds{.vertices = 12, .product = 40};

namespace {

constexpr std::size_t most_stops = 40, most_static = 5;

/// A place in the event array: at a group's scale, or in the interval below it.
struct Stop {
  Rational scale;
  std::uint32_t interval = 0;  ///< below group `interval`
  bool at_group = false;       ///< at group interval - 1, where the interval begins
};

/// Stops at and between all groups of the closed window, ascending; with many groups, some by the
/// dice.
std::vector<Stop> stops_of(const DynamicSum& dynamic, Dice& dice) {
  const ArrangementEvents& events = *dynamic.states().timeline().events;
  const ScaleWindow& window = dynamic.window();
  const auto groups = static_cast<std::uint32_t>(events.groups());
  const std::size_t one_in = 1 + 2 * groups / most_stops;
  std::vector<Stop> stops;
  const auto add = [&](Rational scale, std::uint32_t interval, bool at_group) {
    if (window.from && scale < *window.from) return;
    if (window.to && scale > *window.to) return;
    stops.push_back({std::move(scale), interval, at_group});
  };
  for (std::uint32_t i = 0; i <= groups; ++i) {
    const bool on_boundary = i > 0 && dynamic.states().touches_boundary(i - 1);
    if (!dice.one_in(on_boundary ? 1 + one_in / 4 : one_in)) continue;
    const Rational low = i > 0 ? events.exact(i - 1) : events.window().from.value_or(0);
    const Rational high = i < groups ? events.exact(i) : events.window().to.value_or(2 * low + 1);
    if (i > 0) add(low, i, true);
    add((low + high) / 2, i, false);
  }
  return stops;
}

/// The count entry for an interval.
const TopologyTimeline::Count& count_of(const TopologyTimeline& timeline, std::uint32_t interval) {
  const auto& counts = timeline.counts;
  auto after = std::upper_bound(counts.begin(), counts.end(), interval,
                                [](std::uint32_t i, const auto& c) { return i < c.interval; });
  return after == counts.begin() ? *after : *std::prev(after);
}

void check_counts(const Case& pair, const TopologyTimeline& timeline, const Stop& stop,
                  const Sum& sum) {
  const TopologyTimeline::Count& told = count_of(timeline, stop.interval);
  const bool begins = stop.at_group && told.interval == stop.interval;
  const std::size_t holes = begins ? told.holes_at : told.holes;
  const std::size_t components = begins ? told.components_at : told.components;
  if (sum.holes != holes || sum.components != components) {
    broken("the timeline tells the numbers of holes and components", pair,
           "at " + to_string(stop.scale) + ": told " + std::to_string(holes) + " and " +
               std::to_string(components) + ", counted " + std::to_string(sum.holes) + " and " +
               std::to_string(sum.components));
  }
}

/// Every change of a count has an event, events name existing features, and lives add up.
void check_lives(const Case& pair, const TopologyTimeline& timeline) {
  const auto alive = [](const Feature& f, std::uint32_t interval) {
    return (!f.born || *f.born < interval) && (!f.died || *f.died >= interval);
  };
  for (const auto& count : timeline.counts) {
    const auto living = [&](const std::vector<Feature>& features, std::size_t first) {
      std::size_t n = 0;
      for (std::size_t f = first; f < features.size(); ++f) n += alive(features[f], count.interval);
      return n;
    };
    if (living(timeline.holes, 1) != count.holes ||
        living(timeline.components, 0) != count.components) {
      broken("lives add up to the numbers", pair, "interval " + std::to_string(count.interval));
    }
  }
  std::size_t told = 0, ends = 0;
  for (const auto* features : {&timeline.holes, &timeline.components}) {
    for (const Feature& f : *features) ends += f.born.has_value() + f.died.has_value();
  }
  for (const TopologyEvent& event : timeline.topology) {
    const auto& features = event.kind == FeatureKind::hole ? timeline.holes : timeline.components;
    for (const std::uint32_t f : event.before) {
      if (!alive(features[f], event.group)) broken("what an event ends is there before", pair);
    }
    for (const std::uint32_t f : event.after) {
      if (!alive(features[f], event.group + 1)) broken("what an event begins is there after", pair);
    }
    const std::size_t before = event.before.size(), after = event.after.size();
    told += std::max(before, after) - std::min(before, after);
  }
  if (told != ends) broken("every birth and death has an event", pair);
}

/// Walks up through all stops, down through some, finally at random; computes a sum at each stop.
void check_walk(const Case& pair, DynamicSum& dynamic, const TopologyTimeline& timeline,
                Dice& dice) {
  const std::vector<Stop> stops = stops_of(dynamic, dice);
  if (stops.empty()) return;
  std::vector<PolygonSet> known;
  const auto from_scratch = [&] {
    const std::string wrong = difference_from_scratch(dynamic, pair.P, pair.Q);
    if (!wrong.empty()) broken("the dynamic sum is the static one", pair, wrong);
  };
  const std::size_t static_one_in = 1 + stops.size() / most_static;
  for (const Stop& stop : stops) {
    dynamic.move_to(stop.scale);
    Sum sum = dynamic.sum();
    check_counts(pair, timeline, stop, sum);
    if (dice.one_in(static_one_in)) from_scratch();
    known.push_back(std::move(sum.region));
  }
  const auto again = [&](std::size_t i) {
    dynamic.move_to(stops[i].scale);
    if (dynamic.sum().region != known[i]) {
      broken("a scale has one sum, whichever way it is reached", pair, to_string(stops[i].scale));
    }
  };
  for (std::size_t i = stops.size(); i-- > 0;) {
    if (dice.one_in(3)) again(i);
  }
  for (int jump = 0; jump < 4; ++jump) again(dice.below(stops.size()));
  from_scratch();
}

/// A window keeps its events and counts unchanged.
void check_window(const Case& pair, const DynamicSum& dynamic, const TopologyTimeline& timeline) {
  const DynamicSum whole(pair.P, pair.Q, {});
  const ArrangementEvents &all = *whole.states().timeline().events,
                          &some = *dynamic.states().timeline().events;
  const TopologyTimeline of_all = topology_timeline(whole.states());
  for (std::uint32_t i = 0; i <= some.groups(); ++i) {
    // A scale inside the interval, and the same interval of the whole.
    const Rational low = i > 0 ? some.exact(i - 1) : some.window().from.value_or(0);
    const Rational high =
        i < some.groups() ? some.exact(i) : some.window().to.value_or(2 * low + 1);
    const auto there = all.locate((low + high) / 2);
    const auto &mine = count_of(timeline, i), &its = count_of(of_all, there.before);
    if (there.at || mine.holes != its.holes || mine.components != its.components) {
      broken("a window has the events and numbers of all scales", pair, to_string(low));
    }
  }
}

void check(const Case& pair, Dice& dice) {
  ScaleWindow window;
  if (pair.interval) window = {pair.interval->from, pair.interval->to};
  DynamicSum dynamic(pair.P, pair.Q, window);
  if (dynamic.empty()) return;
  const TopologyTimeline timeline = topology_timeline(dynamic.states());
  check_lives(pair, timeline);
  check_walk(pair, dynamic, timeline, dice);
  for (const Rational& s : pair.scales) {
    dynamic.move_to(s);
    const std::string wrong = difference_from_scratch(dynamic, pair.P, pair.Q);
    if (!wrong.empty()) broken("the dynamic sum is the static one", pair, wrong);
  }
  if ((window.from || window.to) && dice.one_in(3)) check_window(pair, dynamic, timeline);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_pair(data, size, minkref::fuzzing::check);
}
