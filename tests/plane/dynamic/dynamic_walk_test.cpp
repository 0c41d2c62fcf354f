// The law of the dynamic sum: a step leads to the same state as starting from scratch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/paper/trials/from_scratch.hpp"
#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_dynamic_walk {
namespace {

/// A scale within the window, every third one an event's scale.
Rational some_scale(Source& random, const DynamicSum& dynamic) {
  const ArrangementEvents& events = *dynamic.states().timeline().events;
  const ScaleWindow& window = dynamic.window();
  for (;;) {
    Rational s(1 + static_cast<long>(random.below(600)), 1 + static_cast<long>(random.below(200)));
    if (events.groups() > 0 && random.below(3) == 0) {
      s = events.exact(static_cast<std::uint32_t>(random.below(events.groups())));
    } else if (window.from && window.to) {
      s = *window.from + (*window.to - *window.from) * Rational(1 + random.below(998), 1000);
    }
    if (window.from && s < *window.from) continue;
    if (window.to && s > *window.to) continue;
    return s;
  }
}

TEST(DynamicWalk, AStepLeadsToTheStaticArrangementAndSum) {
  MINKREF_SEEDED(random, 400);
  std::size_t at_events = 0, stops = 0;
  expect_law(random, 120, [&](const Case& c) -> std::string {
    ScaleWindow window;
    if (c.scale == 2) window = {Rational(1, 2), Rational(3)};
    DynamicSum dynamic(c.P, c.Q, window);
    Source walk(17);
    for (int step = 0; step < 12; ++step) {
      dynamic.move_to(some_scale(walk, dynamic));
      ++stops;
      at_events += dynamic.arrangement().at_event();
      const std::string wrong = difference_from_scratch(dynamic, c.P, c.Q);
      if (!wrong.empty()) return wrong;
    }
    return "";
  });
  EXPECT_GT(at_events, stops / 6);
}

PolygonSet star(int spikes, double radius) {
  PolygonSet set;
  set.polygons.emplace_back();
  for (int k = 0; k < 2 * spikes; ++k) {
    const double angle = 3.14159265358979 * k / spikes, r = k % 2 == 0 ? radius / 3 : radius;
    set.polygons[0].outer.push_back(
        {std::lround(r * std::cos(angle)), std::lround(r * std::sin(angle))});
  }
  return set;
}

/// Wherever the interrupt comes: beside a sum that takes the same steps without one.
TEST(DynamicWalk, AnInterruptedStepLeavesTheArrangementAsItWas) {
  const ScaleWindow window{Rational(1, 2), Rational(2)};
  DynamicSum interrupted(star(15, 10000), star(12, 9000), window),
      beside(star(15, 10000), star(12, 9000), window);
  Source walk(9);
  int interrupts = 0;
  for (int step = 0; step < 60; ++step) {
    const Rational to = some_scale(walk, beside);
    int looks_left = step % 3;
    bool moved = false;
    try {
      const Interruptible interrupt([&] {
        if (looks_left-- == 0) throw std::runtime_error("interrupted");
      });
      interrupted.move_to(to);
      moved = true;
    } catch (const std::runtime_error&) {
      ++interrupts;
    }
    if (moved) beside.move_to(to);
    ASSERT_EQ(interrupted.arrangement().scale(), beside.arrangement().scale());
    ASSERT_EQ(interrupted.arrangement().node_count(), beside.arrangement().node_count());
    for (std::uint32_t e = 0; e < beside.states().timeline().events->edges().size(); ++e) {
      const auto along = interrupted.arrangement().nodes(e), wanted = beside.arrangement().nodes(e);
      ASSERT_TRUE(std::equal(along.begin(), along.end(), wanted.begin(), wanted.end())) << step;
    }
  }
  EXPECT_GT(interrupts, 10);
}

TEST(DynamicWalk, AStepAndItsReverseCancel) {
  MINKREF_SEEDED(random, 401);
  expect_law(random, 60, [](const Case& c) -> std::string {
    DynamicSum dynamic(c.P, c.Q, {});
    Source walk(5);
    DynamicArrangement& arrangement = dynamic.arrangement();
    const Rational from = some_scale(walk, dynamic), to = some_scale(walk, dynamic);
    dynamic.move_to(from);
    std::vector<std::vector<std::uint32_t>> before;
    for (std::uint32_t e = 0; e < dynamic.states().timeline().events->edges().size(); ++e) {
      const auto along = arrangement.nodes(e);
      before.emplace_back(along.begin(), along.end());
    }
    const StepReport there = dynamic.move_to(to), back = dynamic.move_to(from);
    if (there.insertions != back.deletions || there.deletions != back.insertions ||
        there.swaps != back.swaps) {
      return "the way back is not the way there";
    }
    for (std::uint32_t e = 0; e < before.size(); ++e) {
      const auto along = arrangement.nodes(e);
      if (!std::equal(along.begin(), along.end(), before[e].begin(), before[e].end())) {
        return "another order on edge " + std::to_string(e);
      }
    }
    return "";
  });
}

/// A way from one scale to another. At an event's scale, nodes may share a place; a node exists
/// from its first scale to its last, both included.
struct Way {
  Rational from, to;

  bool up() const { return from < to; }
  bool reaches(const Rational& s) const { return up() ? from < s && s <= to : to <= s && s < from; }
  bool leaves(const Rational& s) const { return up() ? from <= s && s < to : to < s && s <= from; }
  /// Two nodes at one place keep their lower order until the way leaves the scale upwards.
  bool swaps_at(const Rational& s) const {
    return up() ? from <= s && s < to : to <= s && s < from;
  }
};

/// Whether a node exists both below and above a scale.
bool stays(const ArrangementEvents& events, const EdgeNode& node, const Rational& s) {
  return (node.from == EdgeNode::always || events.exact(node.from) < s) &&
         (node.to == EdgeNode::always || events.exact(node.to) > s);
}

/// Counts node pairs of an edge that pass each other on the way, from their tracks alone; and edge
/// triples where two edges pass each other along the third. (Two edges on the third's line, equally
/// long at the scale, pass with both ends at once.)
struct Passings {
  std::uint64_t nodes = 0, triples = 0;
};
Passings passings(const ArrangementEvents& events, const Way& way) {
  Passings result;
  const NodeTable& table = events.table();
  for (std::uint32_t e = 0; e < events.edges().size(); ++e) {
    std::set<std::tuple<std::uint32_t, std::uint32_t, Rational>> others;
    for (std::uint32_t n = table.begin(e); n < table.end(e); ++n) {
      for (std::uint32_t m = table.begin(e); m < n; ++m) {
        const EdgeNode &x = table.nodes[n], &y = table.nodes[m];
        const PlainKernel<Rational> kernel;
        const auto a = node_position(kernel, events.moving(), e, x);
        const auto b = node_position(kernel, events.moving(), e, y);
        const Rational slope = a.slope * b.den - b.slope * a.den;
        if (slope == 0) continue;
        const Rational s = (b.value * a.den - a.value * b.den) / slope;
        if (s <= 0 || !way.swaps_at(s) || !stays(events, x, s) || !stays(events, y, s)) continue;
        ++result.nodes;
        others.emplace(std::min(x.other, y.other), std::max(x.other, y.other), s);
      }
    }
    result.triples += others.size();
  }
  return result;
}

TEST(DynamicWalk, InsertionsDeletionsAndSwapsAreTheEventsCrossed) {
  MINKREF_SEEDED(random, 402);
  std::uint64_t swaps = 0;
  expect_law(random, 80, [&](const Case& c) -> std::string {
    DynamicSum dynamic(c.P, c.Q, {});
    const ArrangementEvents& events = *dynamic.states().timeline().events;
    Source walk(23);
    for (int step = 0; step < 6; ++step) {
      const Way way{dynamic.arrangement().scale(), some_scale(walk, dynamic)};
      const StepReport report = dynamic.move_to(way.to);
      // The first scale lies just above the beginning of the window, which no event precedes.
      if (step == 0) continue;
      std::uint64_t insertions = 0, deletions = 0, triples = 0;
      for (const EdgeNode& node : events.table().nodes) {
        const std::uint32_t first = way.up() ? node.from : node.to;
        const std::uint32_t last = way.up() ? node.to : node.from;
        insertions += first != EdgeNode::always && way.reaches(events.exact(first));
        deletions += last != EdgeNode::always && way.leaves(events.exact(last));
      }
      for (std::size_t t = 0; t < events.triples().size(); ++t) {
        if (!way.swaps_at(events.exact(events.group_of_triple(t)))) continue;
        for (int bit = 0; bit < 3; ++bit) triples += events.triples()[t].swaps >> bit & 1;
      }
      const Passings expected = passings(events, way);
      swaps += report.swaps;
      if (report.insertions != insertions) return "insertions";
      if (report.deletions != deletions) return "deletions";
      if (report.swaps != expected.nodes) return "swaps";
      if (expected.triples != triples) return "triple events";
    }
    return "";
  });
  EXPECT_GT(swaps, 100U);
}

TEST(DynamicWalk, RefusesScalesOutsideTheWindow) {
  const PolygonSet P = box(0, 0, 1, 1), Q = box(0, 0, 2, 3);
  DynamicSum dynamic(P, Q, {Rational(1), Rational(2)});
  EXPECT_THROW(dynamic.move_to(Rational(1, 2)), BadInput);
  EXPECT_THROW(dynamic.move_to(3), BadInput);
  EXPECT_THROW(dynamic.move_to(-1), BadInput);
  dynamic.move_to(1);
  EXPECT_EQ(dynamic.sum().region, minkowski_sum(P, Q, 1).region);
  dynamic.move_to(2);
  EXPECT_EQ(dynamic.sum().region, minkowski_sum(P, Q, 2).region);
}

TEST(DynamicWalk, TakesPointsSegmentsAndTheEmptySet) {
  const PolygonSet Q = region(rectangle(0, 0, 9, 9), {rectangle(2, 2, 5, 4)});
  const std::vector<PolygonSet> operands{point_set(1, 2), segment_set({0, 0}, {1, 1}),
                                         segment_set({0, 0}, {2, 0})};
  for (const PolygonSet& P : operands) {
    DynamicSum first(P, Q, {}), second(Q, P, {});
    for (const Rational& s :
         {Rational(1, 3), Rational(1), Rational(3, 2), Rational(2), Rational(7)}) {
      first.move_to(s);
      EXPECT_EQ(first.sum().region, minkowski_sum(P, Q, s).region) << text(P) << " at " << s;
      second.move_to(s);
      EXPECT_EQ(second.sum().region, minkowski_sum(Q, P, s).region) << text(P) << " at " << s;
    }
  }
  DynamicSum empty({}, Q, {});
  empty.move_to(2);
  EXPECT_TRUE(empty.sum().region.empty());
}

TEST(DynamicWalk, TakesRingsThatTouchAnEdgeWithAPointOrASegment) {
  // Nothing widens the touched edge: the sum does not cover its whole left side.
  const std::vector<PolygonSet> sets{
      region(rectangle(0, 0, 4, 4), {Ring{{0, 2}, {1, 3}, {2, 2}, {1, 1}}}),
      region(rectangle(0, 0, 4, 4), {Ring{{0, 2}, {2, 4}, {4, 2}, {2, 0}}}),
      region(rectangle(0, 0, 9, 9),
             {Ring{{1, 1}, {1, 3}, {3, 3}, {3, 1}}, Ring{{2, 3}, {1, 5}, {3, 5}}})};
  const std::vector<PolygonSet> thin{point_set(0, 0), point_set(2, -1), segment_set({0, 0}, {0, 1}),
                                     segment_set({0, 0}, {1, 0}), segment_set({0, 0}, {1, 1})};
  for (const PolygonSet& Q : sets) {
    for (const PolygonSet& P : thin) {
      for (const auto& [a, b] : {std::pair{P, Q}, std::pair{Q, P}}) {
        DynamicSum dynamic(a, b, {});
        EXPECT_NO_THROW(topology_timeline(dynamic.states())) << text(a) << text(b);
        for (const Rational& s : {Rational(1, 8), Rational(1), Rational(3, 2), Rational(5)}) {
          dynamic.move_to(s);
          EXPECT_EQ(difference_from_scratch(dynamic, a, b), "") << text(a) << text(b);
        }
      }
    }
  }
}

TEST(DynamicWalk, OfAPointOrASegmentLeadsToTheStaticSumToo) {
  MINKREF_SEEDED(random, 404);
  std::size_t stops = 0;
  const auto make = [](Source& source) -> Case {
    const auto number = [&] { return Rational(static_cast<long>(source.below(7)) - 3); };
    const Point a{number(), number()};
    const Point b{a.x + 1 + static_cast<long>(source.below(3)), number()};
    const PolygonSet thin = source.below(3) == 0 ? point_set(a.x, a.y) : segment_set(a, b);
    const PolygonSet wide = random_region(source);
    return source.below(2) == 0 ? Case{thin, wide, 1} : Case{wide, thin, 1};
  };
  expect_law(random, 150, make, [&](const Case& c) -> std::string {
    DynamicSum dynamic(c.P, c.Q, {});
    topology_timeline(dynamic.states());
    Source walk(31);
    for (int step = 0; step < 6; ++step) {
      dynamic.move_to(some_scale(walk, dynamic));
      ++stops;
      const std::string wrong = difference_from_scratch(dynamic, c.P, c.Q);
      if (!wrong.empty()) return wrong;
    }
    return "";
  });
  EXPECT_GE(stops, testing::repetitions(800U));
}

TEST(DynamicWalk, StandsHugeAndTinyNumbers) {
  // Also tests scales far beyond the range of doubles, with coordinates within the range.
  const std::vector<std::pair<const char*, const char*>> factors{
      {"1e200", "1"},      {"1e-200", "1"},    {"1e305", "1e-50"}, {"1e-50", "1e305"},
      {"1e200", "1e-150"}, {"1e-250", "1e90"}, {"1e-315", "1"}};
  MINKREF_SEEDED(random, 403);
  expect_law(random, 10, [&](const Case& c) -> std::string {
    for (const auto& [first, second] : factors) {
      const PolygonSet P = scaled(c.P, parse_rational(first));
      const PolygonSet Q = scaled(c.Q, parse_rational(second));
      DynamicSum dynamic(P, Q, {});
      topology_timeline(dynamic.states());
      const ArrangementEvents& events = *dynamic.states().timeline().events;
      for (std::uint32_t g = 0; g < std::min<std::size_t>(events.groups(), 5); ++g) {
        for (const Rational& s : {events.exact(g), Rational(events.exact(g) * Rational(9, 8))}) {
          dynamic.move_to(s);
          const std::string wrong = difference_from_scratch(dynamic, P, Q);
          if (!wrong.empty()) return wrong;
        }
      }
    }
    return "";
  });
}

}  // namespace
}  // namespace minkref::testing::of_dynamic_walk
