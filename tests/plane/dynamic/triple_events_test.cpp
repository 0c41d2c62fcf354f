// Triple events against their definition, by brute force over all triples of edges.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <set>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_triple_events {
namespace {

using V = Vector2<Rational>;

Rational cross_of(const V& u, const V& v) { return u.x() * v.y() - u.y() * v.x(); }

/// The point at which the lines of two edges cross at a scale, if it is unique; by Cramer's rule.
std::optional<V> crossing(const RationalEdge& a, const RationalEdge& b, const Rational& s) {
  const Rational det = cross_of(a.d, b.d);
  if (sign(det) == 0) return std::nullopt;
  const V pa = V(a.p * s + a.q), pb = V(b.p * s + b.q);
  const Rational ca = cross_of(a.d, pa), cb = cross_of(b.d, pb);
  return V((b.d.x() * ca - a.d.x() * cb) / det, (b.d.y() * ca - a.d.y() * cb) / det);
}

bool on_edge(const RationalEdge& e, const V& x, const Rational& s) {
  const V start = V(e.p * s + e.q), w(x - start);
  if (sign(cross_of(e.d, w)) != 0) return false;
  const Rational along = e.d.dot(w), length = e.d.dot(e.d) * (e.is_s() ? s : Rational(1));
  return sign(along) >= 0 && along <= length;
}

/// The point at which two edges cross at a scale, if they do.
std::optional<V> meeting(const RationalEdge& a, const RationalEdge& b, const Rational& s) {
  const auto x = crossing(a, b, s);
  if (!x || !on_edge(a, *x, s) || !on_edge(b, *x, s)) return std::nullopt;
  return x;
}

/// The unique scale at which the lines of three edges, not all parallel, share a point, if any: the
/// determinant of their equations is linear in s.
std::optional<Rational> concurrency(const std::array<const RationalEdge*, 3>& edges) {
  const auto det = [&](const Rational& s) {
    std::array<Rational, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = cross_of(edges[i]->d, V(edges[i]->p * s + edges[i]->q));
    const auto d = [&](std::size_t i, std::size_t j) { return cross_of(edges[i]->d, edges[j]->d); };
    return Rational(c[0] * d(1, 2) - c[1] * d(0, 2) + c[2] * d(0, 1));
  };
  const Rational at_zero = det(0), slope = det(1) - at_zero;
  if (sign(slope) == 0) return std::nullopt;
  return Rational(-at_zero / slope);
}

using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string, int>;

/// All triple events of crossing edges: (a, b, c, scale, edges along which nodes swap).
std::set<Key> by_definition(const std::vector<RationalEdge>& edges,
                            const std::vector<Rational>& scales) {
  std::set<Key> found;
  const auto n = static_cast<std::uint32_t>(edges.size());
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = b + 1; c < n; ++c) {
        const std::array<const RationalEdge*, 3> three{&edges[a], &edges[b], &edges[c]};
        const auto s = concurrency(three);
        if (!s || sign(*s) <= 0) continue;
        // Just below and just above: no event of the arrangement lies between.
        Rational below = *s / 2, above = *s * 2;
        for (const Rational& other : scales) {
          if (other < *s && other > below) below = (other + *s) / 2;
          if (other > *s && other < above) above = (other + *s) / 2;
        }
        int swaps = 0;
        for (int bit = 0; bit < 3; ++bit) {
          const RationalEdge& e = *three[static_cast<std::size_t>(bit)];
          const RationalEdge& f = *three[static_cast<std::size_t>((bit + 1) % 3)];
          const RationalEdge& g = *three[static_cast<std::size_t>((bit + 2) % 3)];
          const auto f0 = meeting(e, f, below), g0 = meeting(e, g, below);
          const auto f1 = meeting(e, f, above), g1 = meeting(e, g, above);
          if (!f0 || !g0 || !f1 || !g1) continue;
          const int before = sign(Rational(e.d.dot(V(*f0 - *g0))));
          const int after = sign(Rational(e.d.dot(V(*f1 - *g1))));
          if (before * after < 0) swaps |= 1 << bit;
        }
        if (swaps != 0) found.emplace(a, b, c, to_string(*s), swaps);
      }
    }
  }
  return found;
}

TEST(TripleEvents, AreThoseOfTheDefinition) {
  MINKREF_SEEDED(random, 410);
  std::size_t seen = 0;
  expect_law(random, 100, [&](const Case& c) -> std::string {
    const ArrangementEvents events(c.P, c.Q, {});
    if (events.edges().size() > 50) return "";
    std::vector<Rational> scales;
    for (std::uint32_t g = 0; g < events.groups(); ++g) scales.push_back(events.exact(g));
    std::set<Key> actual;
    for (std::size_t t = 0; t < events.triples().size(); ++t) {
      const TripleEvent& e = events.triples()[t];
      const auto crosses = [&](std::uint32_t n) {
        return events.table().nodes[n].kind == EdgeNode::Kind::crossing;
      };
      if (!crosses(e.first) || !crosses(e.second)) continue;  // on one line: no determinant
      actual.emplace(e.a, e.b, e.c, to_string(events.exact(events.group_of_triple(t))),
                     int{e.swaps});
    }
    const std::set<Key> expected = by_definition(events.moving(), scales);
    seen += expected.size();
    return expected == actual ? ""
                              : "expected " + std::to_string(expected.size()) + ", found " +
                                    std::to_string(actual.size());
  });
  EXPECT_GE(seen, testing::repetitions(100U));
}

TEST(TripleEvents, ScalingPDividesTheScales) {
  MINKREF_SEEDED(random, 411);
  expect_law(random, 25, [](const Case& c) -> std::string {
    const Rational factor(3, 2);
    const ArrangementEvents one(c.P, c.Q, {}), other(scaled(c.P, factor), c.Q, {});
    if (one.groups() != other.groups() || one.triples().size() != other.triples().size()) {
      return "another number of events";
    }
    for (std::uint32_t g = 0; g < one.groups(); ++g) {
      if (one.exact(g) != factor * other.exact(g)) return "another scale";
    }
    return "";
  });
}

TEST(TripleEvents, GroupsAscendAndTellEqualScales) {
  MINKREF_SEEDED(random, 412);
  expect_law(random, 40, [](const Case& c) -> std::string {
    const ArrangementEvents events(c.P, c.Q, {});
    for (std::uint32_t g = 0; g < events.groups(); ++g) {
      const auto here = events.locate(events.exact(g));
      if (!here.at || here.before != g) return "a group is not found at its scale";
      if (g > 0 && !(events.exact(g - 1) < events.exact(g))) return "groups do not ascend";
      if (g > 0) {
        const auto between = events.locate((events.exact(g - 1) + events.exact(g)) / 2);
        if (between.at || between.before != g) return "a scale between groups is not";
      }
    }
    return "";
  });
}

TEST(TripleEvents, ADyingTriangularHoleIsNoPairEvent) {
  // The nearest three pair events lie at 541/117, 1082/209 and 1082/163.
  const PolygonSet P = region({{-3, -2}, {4, -1}, {1, 3}});
  const PolygonSet Q = region(rectangle(-40, -40, 40, 40), {{{0, 20}, {17, -11}, {-19, -9}}});
  const ArrangementEvents events(P, Q, {});
  const auto at = events.locate(Rational(541, 186));
  ASSERT_TRUE(at.at);
  EXPECT_EQ(events.pair_event_at(at.before), nullptr);
  EXPECT_NE(events.triple_event_at(at.before), nullptr);
}

}  // namespace
}  // namespace minkref::testing::of_triple_events
