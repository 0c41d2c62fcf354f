// Laws of the sum, without expected values.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_sum_laws {
namespace {

PolygonSet sum(const PolygonSet& P, const PolygonSet& Q, const Rational& scale = 1) {
  return minkowski_sum(P, Q, scale).region;
}

PolygonSet canonical(const PolygonSet& set) { return canonicalize(set).region; }

Point random_vector(Source& random) { return {random.rational(12), random.rational(12)}; }

TEST(SumLaws, RandomOperandsAreOfEveryKind) {
  MINKREF_SEEDED(random, 100);
  int holes = 0, components = 0, straight = 0, touching = 0;
  for (int i = 0; i < 200; ++i) {
    const PolygonSet set = random_region(random);
    ASSERT_NO_THROW(validate(set)) << text(set);
    components += set.polygons.size() > 1;
    std::vector<Point> seen;
    bool touches = false;
    for_each_ring(set, [&](const Ring& ring) {
      for (std::size_t v = 0; v < ring.size(); ++v) {
        straight += is_straight(ring, v);
        touches = touches || std::find(seen.begin(), seen.end(), ring[v]) != seen.end();
      }
      seen.insert(seen.end(), ring.begin(), ring.end());
    });
    touching += touches;
    for (const Polygon& polygon : set.polygons) holes += !polygon.holes.empty();
  }
  EXPECT_GT(holes, 20);
  EXPECT_GT(components, 20);
  EXPECT_GT(straight, 20);
  EXPECT_GT(touching, 20);
}

TEST(SumLaws, TranslationOfEitherOperandTranslatesTheSum) {
  MINKREF_SEEDED(random, 101);
  expect_law(random, 150, [&](const Case& c) {
    const Point p = random_vector(random), q = random_vector(random);
    const PolygonSet expected = shifted(sum(c.P, c.Q, c.scale), c.scale * p + q);
    return unequal(expected, sum(shifted(c.P, p), shifted(c.Q, q), c.scale));
  });
}

TEST(SumLaws, Commutativity) {
  MINKREF_SEEDED(random, 102);
  expect_law(random, 150,
             [](const Case& c) { return unequal(sum(c.P, c.Q, 1), sum(c.Q, c.P, 1)); });
}

TEST(SumLaws, ScalingPIsScalingTheSumOfPAndTheShrunkQ) {
  MINKREF_SEEDED(random, 103);
  expect_law(random, 150, [](const Case& c) {
    const Rational inverse = 1 / c.scale;
    const PolygonSet of_sum = stretched(sum(c.P, stretched(c.Q, inverse)), c.scale);
    const std::string fault = unequal(of_sum, sum(c.P, c.Q, c.scale));
    return fault.empty() ? unequal(of_sum, stretched(sum(c.Q, c.P, inverse), c.scale)) : fault;
  });
}

TEST(SumLaws, ScaleIsScalingOfP) {
  MINKREF_SEEDED(random, 104);
  expect_law(random, 150, [](const Case& c) {
    return unequal(sum(stretched(c.P, c.scale), c.Q), sum(c.P, c.Q, c.scale));
  });
}

TEST(SumLaws, Homogeneity) {
  MINKREF_SEEDED(random, 105);
  expect_law(random, 100, [](const Case& c) {
    const Rational factor(22, 7);
    return unequal(stretched(sum(c.P, c.Q, c.scale), factor),
                   sum(stretched(c.P, factor), stretched(c.Q, factor), c.scale));
  });
}

TEST(SumLaws, Associativity) {
  MINKREF_SEEDED(random, 106);
  expect_law(random, 60, [&](const Case& c) {
    const PolygonSet R = region({{0, 0}, {3, 1}, {1, 2}});
    const PolygonSet left = sum(sum(c.P, c.Q, c.scale), R);
    return unequal(left, sum(c.P, sum(c.Q, R), c.scale));
  });
}

TEST(SumLaws, TheSumIsAnOperand) {
  MINKREF_SEEDED(random, 107);
  expect_law(random, 200, [](const Case& c) {
    validate(sum(c.P, c.Q, c.scale));
    return std::string();
  });
}

TEST(SumLaws, TheSumIsCanonicalAndItsCountsAreThoseOfItsRegion) {
  MINKREF_SEEDED(random, 108);
  expect_law(random, 200, [](const Case& c) -> std::string {
    const Sum s = minkowski_sum(c.P, c.Q, c.scale);
    const Canonical again = canonicalize(s.region);
    if (again.region != s.region) return unequal(again.region, s.region);
    if (again.components != s.components) return "components differ";
    if (again.holes != s.holes) return "holes differ";
    if (s.components != s.region.polygons.size()) return "a polygon for each component";
    return again.well_formed ? "" : "rings overlap";
  });
}

TEST(SumLaws, AreaIsThatOfTheRegionAndAtLeastThatOfTheOperands) {
  MINKREF_SEEDED(random, 109);
  expect_law(random, 100, [](const Case& c) -> std::string {
    const Sum s = minkowski_sum(c.P, c.Q, c.scale);
    Rational doubled = 0;
    for_each_ring(s.region, [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
      }
    });
    if (area(s) != doubled / 2 || area(s.region) != doubled / 2) return "area of the rings";
    // Brunn and Minkowski: sqrt|A + B| >= sqrt|A| + sqrt|B|, so |A + B| >= |A| + |B|.
    const Rational parts = c.scale * c.scale * area(c.P) + area(c.Q);
    return doubled / 2 < parts ? "smaller than its operands" : "";
  });
}

TEST(SumLaws, APointAtTheOriginIsNeutral) {
  MINKREF_SEEDED(random, 110);
  const PolygonSet zero = point_set(0, 0);
  expect_law(random, 150, [&](const Case& c) {
    const std::string fault = unequal(canonical(stretched(c.P, c.scale)), sum(c.P, zero, c.scale));
    return fault.empty() ? unequal(canonical(c.Q), sum(zero, c.Q, c.scale)) : fault;
  });
}

TEST(SumLaws, TheEmptySetAbsorbs) {
  MINKREF_SEEDED(random, 111);
  expect_law(random, 50, [](const Case& c) -> std::string {
    for (const Sum& s :
         {minkowski_sum(c.P, {}, c.scale), minkowski_sum({}, c.Q, c.scale),
          minkowski_sum({}, point_set(1, 2), c.scale), minkowski_sum({}, {}, c.scale)}) {
      if (!s.region.empty() || s.components != 0 || s.holes != 0) return "not empty";
    }
    return "";
  });
}

TEST(SumLaws, Monotonicity) {
  MINKREF_SEEDED(random, 112);
  expect_law(random, 80, random_case, [&](const Case& c) {
    // The larger operand: P and something else.
    const PolygonSet larger = united(c.P, box(-1, -2, 2, 1));
    const PolygonSet big = sum(larger, c.Q, c.scale);
    return unequal(big, united(big, sum(c.P, c.Q, c.scale)));
  });
}

TEST(SumLaws, DistributivityOverUnion) {
  MINKREF_SEEDED(random, 113);
  expect_law(random, 80, [&](const Case& c) {
    const PolygonSet other = region({{-1, 0}, {4, 3}, {1, 7}, {1, 3}});
    const PolygonSet expected = united(sum(c.P, c.Q, c.scale), sum(other, c.Q, c.scale));
    return unequal(expected, sum(united(c.P, other), c.Q, c.scale));
  });
}

TEST(SumLaws, DistributivityOverThePolygonsOfBothOperands) {
  MINKREF_SEEDED(random, 114);
  expect_law(random, 80, lattice_pieces(3, 2), [](const Case& c) {
    PolygonSet expected;
    for (const Polygon& p : c.P.polygons) {
      for (const Polygon& q : c.Q.polygons) {
        expected = together(expected, sum({{p}}, {{q}}, c.scale));
      }
    }
    return unequal(canonical(expected), sum(c.P, c.Q, c.scale));
  });
}

std::vector<Point> points(const PolygonSet& set) {
  std::vector<Point> all;
  for_each_ring(set, [&](const Ring& ring) { all.insert(all.end(), ring.begin(), ring.end()); });
  return all;
}

TEST(SumLaws, HullOfTheSumIsTheSumOfTheHulls) {
  MINKREF_SEEDED(random, 115);
  expect_law(random, 150, [](const Case& c) -> std::string {
    const PolygonSet P = region(convex_hull(points(c.P))), Q = region(convex_hull(points(c.Q)));
    const PolygonSet hulls = sum(P, Q, c.scale);
    const Sum s = minkowski_sum(c.P, c.Q, c.scale);
    if (hulls.polygons.size() != 1) return "the sum of two convex sets is one polygon";
    return unequal(region(convex_hull(points(s.region))), hulls);
  });
}

/// A straight vertex put into every third edge.
PolygonSet refined(PolygonSet set) {
  const auto refine = [](Ring& ring) {
    Ring finer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      finer.push_back(ring[i]);
      const Point d = ring[(i + 1) % ring.size()] - ring[i];
      if (i % 3 != 2) finer.push_back(ring[i] + Rational(1, 3) * d);
      if (i % 3 == 1) finer.push_back(ring[i] + Rational(6, 7) * d);
    }
    ring = std::move(finer);
  };
  for (Polygon& polygon : set.polygons) {
    refine(polygon.outer);
    for (Ring& hole : polygon.holes) refine(hole);
  }
  return set;
}

TEST(SumLaws, StraightVerticesChangeNothing) {
  MINKREF_SEEDED(random, 116);
  expect_law(random, 120, [](const Case& c) {
    const PolygonSet expected = sum(c.P, c.Q, c.scale);
    std::string fault = unequal(expected, sum(refined(c.P), c.Q, c.scale));
    if (fault.empty()) fault = unequal(expected, sum(c.P, refined(c.Q), c.scale));
    return fault.empty() ? unequal(expected, sum(refined(c.P), refined(c.Q), c.scale)) : fault;
  });
}

TEST(SumLaws, StartVertexAndOrderOfRingsChangeNothing) {
  MINKREF_SEEDED(random, 117);
  const auto reordered = [](PolygonSet set) {
    std::reverse(set.polygons.begin(), set.polygons.end());
    for (Polygon& polygon : set.polygons) {
      std::reverse(polygon.holes.begin(), polygon.holes.end());
      std::rotate(polygon.outer.begin(), polygon.outer.begin() + 2, polygon.outer.end());
      for (Ring& hole : polygon.holes) std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    }
    return set;
  };
  expect_law(random, 100, [&](const Case& c) {
    return unequal(sum(c.P, c.Q, c.scale), sum(reordered(c.P), reordered(c.Q), c.scale));
  });
}

TEST(SumLaws, RotationByNinetyDegrees) {
  MINKREF_SEEDED(random, 118);
  expect_law(random, 120, [](const Case& c) {
    return unequal(canonical(turned(sum(c.P, c.Q, c.scale))),
                   sum(turned(c.P), turned(c.Q), c.scale));
  });
}

TEST(SumLaws, Reflection) {
  MINKREF_SEEDED(random, 119);
  expect_law(random, 120, [](const Case& c) {
    return unequal(canonical(mirrored(sum(c.P, c.Q, c.scale))),
                   sum(mirrored(c.P), mirrored(c.Q), c.scale));
  });
}

TEST(SumLaws, AShearIsALinearMapLikeAnyOther) {
  MINKREF_SEEDED(random, 120);
  const auto sheared = [](const PolygonSet& set) {
    return mapped(set, [](const Point& p) {
      return Point{Rational(2 * p.x + p.y / 3), Rational(p.y - p.x / 5)};
    });
  };
  expect_law(random, 100, [&](const Case& c) {
    return unequal(canonical(sheared(sum(c.P, c.Q, c.scale))),
                   sum(sheared(c.P), sheared(c.Q), c.scale));
  });
}

TEST(SumLaws, TwoScalesOfAConvexSetAddUp) {
  MINKREF_SEEDED(random, 121);
  expect_law(random, 150, convex_polygons(), [](const Case& c) {
    return unequal(canonical(stretched(c.Q, c.scale + 1)), sum(c.Q, c.Q, c.scale));
  });
}

}  // namespace
}  // namespace minkref::testing::of_sum_laws
