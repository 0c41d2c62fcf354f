// The law of the dynamic sum by winding numbers: a step of the full convolution leads to the same
// winding numbers and the same sum as starting from scratch.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "reference/error.hpp"
#include "reference/paper/trials/from_scratch.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_winding_walk {
namespace {

DynamicSum by_winding(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window = {}) {
  return {P, Q, window, ConvolutionType::full};
}

/// A scale; every second time an event's, if any exists.
Rational some_scale(Source& random, const DynamicSum& dynamic) {
  const ArrangementEvents& events = *dynamic.states().timeline().events;
  if (events.groups() > 0 && random.coin()) {
    return events.exact(static_cast<std::uint32_t>(random.below(events.groups())));
  }
  return Rational(1 + static_cast<long>(random.below(600)),
                  1 + static_cast<long>(random.below(200)));
}

/// Walks in both directions; the fault, or nothing.
std::string walk(const Case& c, int steps) {
  DynamicSum dynamic = by_winding(c.P, c.Q);
  Source random(19);
  for (int step = 0; step < steps; ++step) {
    dynamic.move_to(some_scale(random, dynamic));
    const std::string wrong = difference_from_scratch(dynamic, c.P, c.Q);
    if (!wrong.empty()) return wrong;
  }
  return "";
}

TEST(WindingWalk, AStepLeadsToTheWindingNumbersAndTheSumFromScratch) {
  MINKREF_SEEDED(random, 410);
  expect_law(random, 60, [](const Case& c) { return walk(c, 6); });
}

TEST(WindingWalk, ParallelEdgesThatPassChangeTheNumbersByTheirSigns) {
  MINKREF_SEEDED(random, 411);
  expect_law(random, 40, lattice_pieces(4, 4), [](const Case& c) { return walk(c, 8); });
}

TEST(WindingWalk, PointsAndSegmentsAreOperands) {
  MINKREF_SEEDED(random, 412);
  expect_law(random, 40, thin_and_wide(3, 2), [](const Case& c) { return walk(c, 5); });
}

/// docs/definitions.md, "Winding numbers": zero about a point inside, unless operands are cut.
TEST(WindingWalk, OperandsWithHolesAreCut) {
  const PolygonSet P = region(rectangle(0, 0, 8, 8), {rectangle(3, 3, 5, 5)});
  const PolygonSet Q = box(0, 0, 20, 20);
  EXPECT_EQ(walk({P, Q, 1}, 20), "");
  EXPECT_EQ(walk({Q, P, 1}, 20), "");
  DynamicSum dynamic = by_winding(P, Q);
  dynamic.move_to(1);
  EXPECT_EQ(dynamic.sum().region, minkowski_sum(P, Q, 1, Route::definition).region);
}

using Named =
    std::tuple<ConvolutionEdge::Kind, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
Named named(const ConvolutionEdge& edge) {
  return {edge.kind, edge.edge.ring, edge.edge.index, edge.vertex.ring, edge.vertex.index};
}

struct BoundaryRow {
  Rational scale, x, y;
  BoundaryEvent::Change change;
  std::set<Named> parents;
  friend bool operator==(const BoundaryRow&, const BoundaryRow&) = default;
};

TEST(WindingWalk, TheBoundaryHasTheSameEventsAsByCollisionDetection) {
  MINKREF_SEEDED(random, 413);
  const auto has_hole = [](const PolygonSet& set) {
    return std::any_of(set.polygons.begin(), set.polygons.end(),
                       [](const Polygon& polygon) { return !polygon.holes.empty(); });
  };
  const auto rows = [](const DynamicSum& dynamic, bool with_parents) {
    std::vector<BoundaryRow> found;
    const BoundaryStates& states = dynamic.states();
    const auto& edges = states.timeline().events->edges();
    for (const BoundaryEvent& event : topology_timeline(states).boundary) {
      BoundaryRow row{states.scale(event.group), event.place.x, event.place.y, event.change, {}};
      if (with_parents) {
        for (const std::uint32_t e : event.edges) row.parents.insert(named(edges[e]));
      }
      found.push_back(std::move(row));
    }
    return found;
  };
  expect_law(random, 40, [&](const Case& c) -> std::string {
    // Along the rings of cut operands, vertices have other numbers.
    const bool parents = !has_hole(c.P) && !has_hole(c.Q);
    const DynamicSum reduced(c.P, c.Q, {}), full = by_winding(c.P, c.Q);
    return rows(reduced, parents) == rows(full, parents) ? "" : "other boundary events";
  });
}

TEST(WindingWalk, TheFullConvolutionHasAllEventsOfTheReducedOne) {
  MINKREF_SEEDED(random, 414);
  std::size_t more = 0;
  expect_law(random, 40, [&](const Case& c) -> std::string {
    const PolygonSet P = cut_to_simply_connected(c.P), Q = cut_to_simply_connected(c.Q);
    const auto events_of = [&](ConvolutionType type) {
      const PairEvents found = pair_events(P, Q, {}, EventKind::both, Form::corrected, false, type);
      const std::vector<Rational> scales = critical_scales(found, P, Q);
      std::vector<std::tuple<Rational, Change, Named, Named>> rows;
      for (const PairEvent& e : found.events) {
        const Named a = named(found.edges[e.a]), b = named(found.edges[e.b]);
        rows.emplace_back(scales[e.rank], e.change, std::min(a, b), std::max(a, b));
      }
      std::sort(rows.begin(), rows.end());
      return rows;
    };
    const auto few = events_of(ConvolutionType::reduced), all = events_of(ConvolutionType::full);
    more += all.size() - few.size();
    return std::includes(all.begin(), all.end(), few.begin(), few.end()) ? "" : "an event is lost";
  });
  EXPECT_GT(more, 0U);
}

TEST(WindingWalk, StaysWithinItsWindow) {
  const PolygonSet P = box(0, 0, 1, 1), Q = region(rectangle(0, 0, 9, 9), {rectangle(2, 2, 5, 4)});
  DynamicSum dynamic = by_winding(P, Q, {Rational(1), Rational(3)});
  EXPECT_THROW(dynamic.move_to(4), BadInput);
  for (const Rational& s : {Rational(1), Rational(2), Rational(5, 2), Rational(3)}) {
    dynamic.move_to(s);
    EXPECT_EQ(difference_from_scratch(dynamic, P, Q), "") << s;
  }
  DynamicSum empty = by_winding({}, Q);
  empty.move_to(2);
  EXPECT_TRUE(empty.sum().region.empty());
}

}  // namespace
}  // namespace minkref::testing::of_winding_walk
