// Each point set has exactly one text.
#include <gtest/gtest.h>

#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_canonical {
namespace {

std::string digest_text(const PolygonSet& set) { return canonical_json(canonicalize(set).region); }

TEST(Canonical, UnitSquareIsTheTextOfTheDefinition) {
  EXPECT_EQ(digest_text(region({{1, 1}, {0, 1}, {0, 0}, {1, 0}})),
            "{\"polygons\":[{\"holes\":[],\"outer\":[[\"0\",\"0\"],[\"1\",\"0\"],[\"1\",\"1\"],"
            "[\"0\",\"1\"]]}]}");
  EXPECT_EQ(digest_text({}), "{\"polygons\":[]}");
}

TEST(Canonical, NumbersAreInLowestTermsAndComparedAsNumbers) {
  // As texts "-1/2" < "-3/4"; as numbers -3/4 < -1/2, and 9 < 10.
  const PolygonSet set =
      region({{Rational(-1, 2), 0}, {Rational(-6, 8), 9}, {Rational(-3, 4), 10}, {4, 9}});
  EXPECT_EQ(digest_text(set),
            "{\"polygons\":[{\"holes\":[],\"outer\":[[\"-3/4\",\"9\"],[\"-1/2\",\"0\"],"
            "[\"4\",\"9\"],[\"-3/4\",\"10\"]]}]}");
}

TEST(Canonical, SquareWithADiamondTouchingTwoSidesIsTwoPolygonsHoweverGiven) {
  const Ring diamond{{2, 0}, {1, 2}, {2, 4}, {3, 2}};
  const PolygonSet with_hole = region(rectangle(0, 0, 4, 4), {diamond});
  const PolygonSet two = together(region({{0, 0}, {2, 0}, {1, 2}, {2, 4}, {0, 4}}),
                                  region({{2, 0}, {4, 0}, {4, 4}, {2, 4}, {3, 2}}));
  ASSERT_NO_THROW(validate(with_hole));
  ASSERT_NO_THROW(validate(two));
  EXPECT_EQ(digest_text(with_hole), digest_text(two));
  for (const PolygonSet& set : {with_hole, two}) {
    const Canonical form = canonicalize(set);
    EXPECT_TRUE(form.well_formed);
    EXPECT_EQ(form.components, 2U);
    EXPECT_EQ(form.holes, 1U);  // the diamond is a bounded component of the complement
    ASSERT_EQ(form.region.polygons.size(), 2U);
    EXPECT_EQ(form.region, two);
  }
}

TEST(Canonical, DiamondTouchingOneSideIsAHole) {
  const PolygonSet set = region(rectangle(0, 0, 4, 4), {{{2, 0}, {1, 2}, {2, 3}, {3, 2}}});
  const Canonical form = canonicalize(set);
  EXPECT_EQ(form.components, 1U);
  EXPECT_EQ(form.holes, 1U);
  EXPECT_EQ(form.region,
            (PolygonSet{{{rectangle(0, 0, 4, 4), {{{1, 2}, {2, 3}, {3, 2}, {2, 0}}}}}}));
}

TEST(Canonical, DiamondTouchingAllFourSidesLeavesFourTriangles) {
  const PolygonSet set = region(rectangle(0, 0, 4, 4), {{{2, 0}, {0, 2}, {2, 4}, {4, 2}}});
  const Canonical form = canonicalize(set);
  EXPECT_EQ(form.components, 4U);
  EXPECT_EQ(form.holes, 1U);
  EXPECT_EQ(form.region.polygons.size(), 4U);
}

TEST(Canonical, HolePinchedAtAPointIsTwoHolesAndTwoRings) {
  // A bow tie of two triangles, as one polygon's holes that touch at (3,3).
  const PolygonSet two =
      region(rectangle(0, 0, 6, 6), {{{1, 2}, {1, 4}, {3, 3}}, {{5, 4}, {5, 2}, {3, 3}}});
  ASSERT_NO_THROW(validate(two));
  const Canonical form = canonicalize(two);
  EXPECT_EQ(form.components, 1U);
  EXPECT_EQ(form.holes, 2U);
  ASSERT_EQ(form.region.polygons.size(), 1U);
  EXPECT_EQ(form.region.polygons[0].holes.size(), 2U);
}

TEST(Canonical, AComponentThatTouchesItselfIsAnOuterRingWithAHole) {
  // A ring of cells around (1,1)-(2,2) without the cell at (2,2): the hole's corner lies on the
  // outer boundary, which is pinched there.
  const PolygonSet as_outer_and_hole =
      region({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}}, {rectangle(1, 1, 2, 2)});
  ASSERT_NO_THROW(validate(as_outer_and_hole));
  const Canonical form = canonicalize(as_outer_and_hole);
  EXPECT_EQ(form.components, 1U);
  EXPECT_EQ(form.holes, 1U);
  EXPECT_EQ(form.region, (PolygonSet{{{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 3}, {0, 3}},
                                       {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}}));
}

TEST(Canonical, TwoHolesThatTouchTwiceCutOutAnIsland) {
  // Two U-shaped holes whose tips meet at two points: the part between them is a separate
  // component, and the complement has two bounded components.
  const PolygonSet set =
      region(rectangle(0, 0, 10, 10), {{{2, 5}, {2, 2}, {8, 2}, {8, 5}, {6, 4}, {4, 4}},
                                       {{2, 5}, {4, 6}, {6, 6}, {8, 5}, {8, 8}, {2, 8}}});
  ASSERT_NO_THROW(validate(set));
  const Canonical form = canonicalize(set);
  EXPECT_EQ(form.components, 2U);
  EXPECT_EQ(form.holes, 2U);
  EXPECT_EQ(area(form.region), area(set));
}

TEST(Canonical, IsIdempotentAndKeepsThePointsOfTheSet) {
  MINKREF_SEEDED(random, 400);
  expect_law(random, 300, [](const Case& c) -> std::string {
    const Canonical form = canonicalize(c.P);
    if (!form.well_formed) return "not well formed";
    if (canonicalize(form.region).region != form.region) return "not idempotent";
    if (area(form.region) != area(c.P)) return "another area";
    validate(form.region);
    for (int x = -16; x <= 26; x += 3) {
      for (int y = -16; y <= 26; y += 3) {
        const Point at{Rational(x, 2), Rational(y, 2)};
        if (where(c.P, at) != where(form.region, at)) return "another set at " + text(at);
      }
    }
    return "";
  });
}

TEST(Canonical, RingsStartAtTheLeastVertexAndAreSorted) {
  MINKREF_SEEDED(random, 401);
  const auto less = [](const Ring& a, const Ring& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less_xy);
  };
  expect_law(random, 300, [&](const Case& c) -> std::string {
    const PolygonSet set = canonicalize(c.P).region;
    std::string fault;
    for (const Polygon& polygon : set.polygons) {
      if (sign(doubled_area(polygon.outer)) <= 0) fault = "outer ring not counter-clockwise";
      for (const Ring& hole : polygon.holes) {
        if (sign(doubled_area(hole)) >= 0) fault = "hole not clockwise";
      }
      if (!std::is_sorted(polygon.holes.begin(), polygon.holes.end(), less)) fault = "holes' order";
    }
    for_each_ring(set, [&](const Ring& ring) {
      if (std::min_element(ring.begin(), ring.end(), less_xy) != ring.begin()) fault = "start";
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (is_straight(ring, i)) fault = "straight vertex";
      }
    });
    const auto by_outer = [&](const Polygon& a, const Polygon& b) {
      return less(a.outer, b.outer);
    };
    if (!std::is_sorted(set.polygons.begin(), set.polygons.end(), by_outer)) fault = "order";
    return fault;
  });
}

TEST(Canonical, DoesNotDependOnHowTheRingsAreGiven) {
  MINKREF_SEEDED(random, 402);
  expect_law(random, 200, [](const Case& c) {
    const Canonical form = canonicalize(c.P);
    PolygonSet other = c.P;
    std::reverse(other.polygons.begin(), other.polygons.end());
    for (Polygon& polygon : other.polygons) {
      std::rotate(polygon.outer.begin(), polygon.outer.begin() + 1, polygon.outer.end());
      std::reverse(polygon.holes.begin(), polygon.holes.end());
    }
    return unequal(form.region, canonicalize(other).region);
  });
}

TEST(Canonical, OverlappingRingsGiveTheUnionAndSaySo) {
  const Canonical form = canonicalize(together(box(0, 0, 2, 2), box(1, 1, 3, 3)));
  EXPECT_FALSE(form.well_formed);
  EXPECT_EQ(form.region.polygons,
            region({{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}, {0, 2}}).polygons);
  // Side by side, sharing an edge: no winding number exceeds 1.
  const Canonical beside = canonicalize(together(box(0, 0, 1, 1), box(1, 0, 2, 1)));
  EXPECT_TRUE(beside.well_formed);
  EXPECT_EQ(beside.region, box(0, 0, 2, 1));
  // Twice the same set.
  EXPECT_EQ(canonicalize(together(box(0, 0, 1, 1), box(0, 0, 1, 1))).region, box(0, 0, 1, 1));
  EXPECT_FALSE(canonicalize(together(box(0, 0, 1, 1), box(0, 0, 1, 1))).well_formed);
}

TEST(Canonical, UnionHoldsThePointsOfEither) {
  MINKREF_SEEDED(random, 403);
  expect_law(random, 150, [](const Case& c) -> std::string {
    const PolygonSet both = united(c.P, c.Q);
    for (int x = -33; x <= 53; x += 7) {
      for (int y = -33; y <= 53; y += 7) {
        const Point at{Rational(x, 4), Rational(y, 4)};
        const Where p = where(c.P, at), q = where(c.Q, at), u = where(both, at);
        const bool either = p == Where::inside || q == Where::inside;
        if (either && u != Where::inside) return "lost " + text(at);
        if (u == Where::inside && p == Where::outside && q == Where::outside) {
          return "invented " + text(at);
        }
        if ((p != Where::outside || q != Where::outside) && u == Where::outside) {
          return "lost the boundary at " + text(at);
        }
      }
    }
    return "";
  });
}

}  // namespace
}  // namespace minkref::testing::of_canonical
