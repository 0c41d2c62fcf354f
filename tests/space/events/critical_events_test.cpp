// The event list of a pair of polyhedra: boxes find the same events as all pairs, and laws hold.
#include "reference/space/critical/critical_events.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/space/critical/crossing_facets.hpp"
#include "reference/space/critical/parallel_facets.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_critical_events {
namespace {

using bodies::for_each_seed;
using polycubes::block;
using polycubes::solid;
using polycubes::without;

std::string text(const CriticalEvents& found) {
  std::string text;
  for (const SpacePairEvent& e : found.events) {
    text += to_string(e.event.s.exact()) + ' ' + std::to_string(e.first) + ' ' +
            std::to_string(e.second) + ' ' + std::to_string(static_cast<int>(e.event.kind)) +
            std::to_string(static_cast<int>(e.event.change)) + ' ' +
            std::to_string(e.event.of_first) + ' ' + std::to_string(e.event.of_second) + '\n';
  }
  for (const ConcurrentEvent& e : found.concurrent) {
    text += to_string(e.s.exact());
    for (const std::uint32_t facet : e.facets) text += ' ' + std::to_string(facet);
    for (const std::uint8_t side : e.sides) text += ' ' + std::to_string(side);
    text += ' ' + std::to_string(static_cast<int>(e.change)) + '\n';
  }
  return text;
}

std::size_t expect_all(const Polyhedron& P, const Polyhedron& Q, unsigned threads = 1) {
  const Rational from(1, 5), to(2);
  BuildOptions options;
  options.threads = threads;
  const CriticalEvents found = critical_events_in_space(P, Q, from, to, options, EventsOf::all);
  EXPECT_EQ(text(found), text(critical_events_of_all_pairs(P, Q, from, to, EventsOf::all)));
  return found.events.size();
}

Polyhedron random_solid(std::mt19937& dice) {
  const auto matrix = dice() % 2 == 0 ? polycubes::identity : polycubes::random_matrix(dice, 4);
  for (;;) {
    const Polyhedron body = solid(polycubes::random_cells(dice, 1 + dice() % 4, 2), matrix);
    if (polycubes::is_valid(body)) return body;
  }
}

TEST(CriticalEvents, AreThoseOfAllPairsOfFacets) {
  std::size_t events = 0;
  for_each_seed(30, [&](std::mt19937& dice) {
    const Polyhedron P = random_solid(dice);
    const Polyhedron Q = dice() % 3 == 0 ? bodies::random_tetrahedron(dice, 6) : random_solid(dice);
    events += expect_all(P, Q, 1 + dice() % 2);
  });
  EXPECT_GE(events, testing::repetitions(1000U));
}

/// Moves up and down, to any scale: the meeting pairs equal the pairs from scratch.
TEST(CriticalEvents, LeadFromOneScaleToAnother) {
  std::uint64_t events = 0;
  for_each_seed(10, [&](std::mt19937& dice) {
    const Polyhedron P = random_solid(dice), Q = random_solid(dice);
    const auto found = std::make_shared<const CriticalEvents>(
        critical_events_in_space(P, Q, Rational(1, 5), Rational(2)));
    const auto scale = [&] { return Rational(201 + static_cast<int>(dice() % 1790), 997); };
    CrossingFacets crossing(found, scale());
    for (int step = 0; step < 6; ++step) {
      const Rational s = scale();
      events += crossing.move_to(s);
      const auto pairs = meeting_pairs_at(*found->convolution, s);
      ASSERT_EQ(crossing.pairs(), pairs) << "at " << s;
      ASSERT_EQ(crossing.count(), pairs.size());
    }
    if (!found->events.empty()) {
      EXPECT_THROW(crossing.move_to(found->events[0].event.s.exact()), BadInput);
    }
  });
  EXPECT_GE(events, testing::repetitions(500U));
}

TEST(CriticalEvents, OfConvexOperandsThereAreNone) {
  for_each_seed(10, [&](std::mt19937& dice) {
    const Polyhedron P = bodies::random_tetrahedron(dice, 20),
                     Q = bodies::random_tetrahedron(dice, 20);
    const CriticalEvents found = critical_events_in_space(P, Q, Rational(1, 5), Rational(2));
    EXPECT_GT(found.convolution->facets.size(), 7U);
    EXPECT_EQ(found.events.size(), 0U);
  });
}

/// A triangle of an operand at a vertex of the other operand.
MovingFacet triangle(const SpaceOperand& body, std::array<std::uint32_t, 3> corners, bool of_P,
                     std::uint32_t vertex) {
  MovingFacet facet{of_P ? FacetKind::fv : FacetKind::vf, 3, 0, 0, {}, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    facet.names[k] = of_P ? ConvolutionFacet::Corner{corners[k], vertex}
                          : ConvolutionFacet::Corner{vertex, corners[k]};
    facet.along[k] = FilteredVector(
        body.points[corners[(k + 1) % 3]].exact - body.points[corners[k]].exact, body.shift);
  }
  facet.normal = FilteredVector(cross(facet.along[0].exact, facet.along[1].exact), 2 * body.shift);
  return facet;
}

/// Fig. 4: at one scale, two long triangles across each other share a plane.
TEST(CriticalEvents, ParallelFacetsWithoutAVertexInTheOther) {
  const Polyhedron P = bodies::tetrahedron({-9, 0, 1}, {9, -1, 1}, {9, 1, 1}, {0, 0, 0}),
                   Q = bodies::tetrahedron({0, -9, 3}, {1, 9, 3}, {-1, 9, 3}, {0, 0, 2});
  const SpaceOperands operands = space_operands(P, Q, bodies::unit);
  const MovingConvolution convolution(operands.P, operands.Q);
  const auto corner = [](const SpaceOperand& body, int x, int y, int z) {
    for (std::uint32_t v = 0; v < body.points.size(); ++v) {
      if (body.points[v].exact == IntegerVector{x, y, z}) return v;
    }
    return none;
  };
  const SpaceOperand &p = operands.P, &q = operands.Q;
  const MovingFacet first = triangle(
      p, {corner(p, -9, 0, 1), corner(p, 9, -1, 1), corner(p, 9, 1, 1)}, true, corner(q, 0, 0, 2));
  const MovingFacet second = triangle(
      q, {corner(q, 0, -9, 3), corner(q, 1, 9, 3), corner(q, -1, 9, 3)}, false, corner(p, 0, 0, 0));
  space::SignCounts signs;
  for (const auto& events : {parallel_events(convolution, first, second, signs),
                             parallel_events(convolution, second, first, signs)}) {
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, ContactKind::parallel);
    EXPECT_EQ(events[0].change, ContactChange::touch);
    EXPECT_EQ(events[0].s.exact(), 1);
    EXPECT_EQ(events[0].of_first, FacetEvent::no_corner);
    EXPECT_EQ(events[0].of_second, FacetEvent::no_corner);
  }
}

/// t (sP) ⊕ Q: the same events at other scales.
TEST(CriticalEvents, ScaleWithP) {
  std::mt19937 dice(3);
  const Polyhedron P = solid(without(block({0, 0, 0}, {3, 3, 1}), block({1, 1, 0}, {2, 2, 1})),
                             {{{5, 0, 0}, {0, 5, 0}, {0, 0, 5}}}),
                   Q = bodies::random_tetrahedron(dice, 5);
  Polyhedron half = P;
  for (SpacePoint& p : half.vertices) p = {p.x / 2, p.y / 2, p.z / 2};
  const CriticalEvents one = critical_events_in_space(P, Q, Rational(1, 5), Rational(2)),
                       other = critical_events_in_space(half, Q, Rational(2, 5), Rational(4));
  ASSERT_EQ(one.events.size(), other.events.size());
  ASSERT_GT(one.events.size(), 0U);
  for (std::size_t k = 0; k < one.events.size(); ++k) {
    EXPECT_EQ(one.events[k].event.s.exact() * 2, other.events[k].event.s.exact());
    EXPECT_EQ(one.events[k].first, other.events[k].first);
  }
}

TEST(CriticalEvents, RefusesWindowsThatAreNone) {
  const Polyhedron P = bodies::box(1, 1, 1);
  EXPECT_THROW(critical_events_in_space(P, P, Rational(0), Rational(1)), BadInput);
  EXPECT_THROW(critical_events_in_space(P, P, Rational(2), Rational(1)), BadInput);
}

}  // namespace
}  // namespace minkref::of_critical_events
