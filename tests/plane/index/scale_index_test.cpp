// The region read off the index is the sum.
#include "reference/plane/index/scale_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/error.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_scale_index {
namespace {

TEST(ScaleIndex, GivesTheSumAtAndBetweenAllEvents) {
  MINKREF_SEEDED(random, 920);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleIndex index(c.P, c.Q, some_window(c));
    for (const Rational& scale : telling_scales(index)) {
      const std::string fault = fault_of_sum(c.P, c.Q, scale, index.sum(scale));
      if (!fault.empty()) return fault;
    }
    return "";
  });
}

std::vector<std::pair<double, double>> vertices(const PolygonSet& set) {
  std::vector<std::pair<double, double>> result;
  const auto add = [&](const Ring& ring) {
    for (const Point& p : ring) result.emplace_back(to_double(p.x), to_double(p.y));
  };
  for (const Polygon& polygon : set.polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return result;
}

TEST(ScaleIndex, RingsInDoublesAreThoseOfTheSumWithinTheirError) {
  MINKREF_SEEDED(random, 921);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const ScaleIndex index(c.P, c.Q, some_window(c));
    RoundedRings rings;
    for (const Rational& scale : telling_scales(index)) {
      index.rings(scale, rings);
      const Sum sum = minkowski_sum(c.P, c.Q, scale);
      const auto expected = vertices(sum.region);
      if (expected.size() != rings.x.size()) {
        return "at scale " + to_string(scale) + ": " + std::to_string(rings.x.size()) +
               " vertices, not " + std::to_string(expected.size());
      }
      if (rings.ring_ends.size() != sum.region.rings()) return "other rings";
      for (const auto& [x, y] : expected) {
        bool found = false;
        for (std::size_t k = 0; k < rings.x.size(); ++k) {
          found = found || (std::fabs(rings.x[k] - x) <= rings.error + std::fabs(x) * 0x1p-52 &&
                            std::fabs(rings.y[k] - y) <= rings.error + std::fabs(y) * 0x1p-52);
        }
        if (!found) return "at scale " + to_string(scale) + ": a vertex is missing";
      }
      double area = 0;
      for (std::size_t ring = 0, first = 0; ring < rings.ring_ends.size(); ++ring) {
        const std::size_t end = rings.ring_ends[ring];
        for (std::size_t k = first; k < end; ++k) {
          const std::size_t next = k + 1 == end ? first : k + 1;
          area += (rings.x[k] * rings.y[next] - rings.y[k] * rings.x[next]) / 2;
        }
        first = end;
      }
      if (std::fabs(area - to_double(minkref::area(sum))) > 1e-9 * (1 + std::fabs(area))) {
        return "at scale " + to_string(scale) + ": the rings enclose another area";
      }
    }
    return "";
  });
}

/// The vertices of a column with `per` integers each, as points.
std::vector<Point> points(const IntegerColumn& column, std::size_t per) {
  std::vector<Point> result;
  for (std::size_t k = 0; k < column.size(); k += per) {
    result.push_back(
        per == 3
            ? Point{Rational(column[k], column[k + 2]), Rational(column[k + 1], column[k + 2])}
            : Point{Rational(column[k], column[k + 1]), Rational(column[k + 2], column[k + 3])});
  }
  return result;
}

TEST(ScaleIndex, AllFormsAreTheSameRings) {
  MINKREF_SEEDED(random, 922);
  expect_law(random, 40, [](const Case& c) -> std::string {
    // Tests short numbers and long numbers: a shift by 1 / 3^60 only moves the sum.
    Case far = c;
    Rational shift = 1;
    for (int k = 0; k < 60; ++k) shift /= 3;
    for (Polygon& polygon : far.P.polygons) {
      for (Point& p : polygon.outer) p.x += shift;
      for (Ring& hole : polygon.holes) {
        for (Point& p : hole) p.x += shift;
      }
    }
    for (const Case* one : {&c, static_cast<const Case*>(&far)}) {
      const ScaleIndex index(one->P, one->Q, some_window(*one));
      TrackRings tracks;
      RoundedRings rounded;
      HomogeneousRings homogeneous;
      RationalRings rational;
      for (const Rational& scale : telling_scales(index)) {
        index.rings(scale, tracks);
        index.rings(scale, rounded);
        index.rings(scale, homogeneous);
        index.rings(scale, rational);
        const auto same_shape = [&](const RingShape& shape) {
          return shape.ring_ends == tracks.ring_ends && shape.edges == tracks.edges &&
                 shape.rings.size() == tracks.rings.size();
        };
        if (!same_shape(rounded) || !same_shape(homogeneous) || !same_shape(rational)) {
          return "other rings at " + to_string(scale);
        }
        std::vector<Point> expected;
        for (const std::uint32_t track : tracks.tracks) {
          expected.push_back(index.track(track).at(scale));
        }
        if (points(homogeneous.column(), 3) != expected)
          return "homogeneous at " + to_string(scale);
        if (points(rational.column(), 4) != expected) return "reduced at " + to_string(scale);
        const IntegerColumn numbers = rational.column();
        for (std::size_t k = 0; k < numbers.size(); k += 2) {
          if (gcd(numbers[k], numbers[k + 1]) != 1) return "not in lowest terms";
        }
        for (std::size_t k = 0; k < expected.size(); ++k) {
          const Rational error = from_double(rounded.error);
          if (abs(from_double(rounded.x[k]) - expected[k].x) > error ||
              abs(from_double(rounded.y[k]) - expected[k].y) > error) {
            return "a double is off by more than its error at " + to_string(scale);
          }
        }
      }
    }
    return "";
  });
}

TEST(ScaleIndex, ASideLiesOnTheEdgeThatIsNamed) {
  MINKREF_SEEDED(random, 923);
  expect_law(random, 40, [](const Case& c) -> std::string {
    const ScaleIndex index(c.P, c.Q, some_window(c));
    const auto edges = index.edges();
    TrackRings rings;
    for (const Rational& scale : telling_scales(index)) {
      index.rings(scale, rings);
      std::size_t first = 0;
      for (const std::uint32_t end : rings.ring_ends) {
        for (std::size_t k = first; k < end; ++k) {
          const Point from = index.track(rings.tracks[k]).at(scale),
                      to = index.track(rings.tracks[k + 1 == end ? first : k + 1]).at(scale);
          const Segment edge = at_scale(edges[rings.edges[k]], c.P, c.Q, scale);
          const Rational dx = edge.end.x - edge.start.x, dy = edge.end.y - edge.start.y;
          if (dx * (from.y - edge.start.y) != dy * (from.x - edge.start.x) ||
              dx * (to.y - from.y) != dy * (to.x - from.x) ||
              dx * (to.x - from.x) + dy * (to.y - from.y) <= 0) {
            return "at " + to_string(scale);
          }
        }
        first = end;
      }
    }
    return "";
  });
}

TEST(ScaleIndex, AreaAndFeaturesNeedNoBoundary) {
  MINKREF_SEEDED(random, 924);
  expect_law(random, 40, [](const Case& c) -> std::string {
    const ScaleIndex index(c.P, c.Q, some_window(c));
    for (const Rational& scale : telling_scales(index)) {
      const Sum sum = minkowski_sum(c.P, c.Q, scale);
      const Rational exact = minkref::area(sum);
      const auto told = index.area(scale);
      if (abs(from_double(told.value) - exact) > from_double(told.error)) {
        return "the area at " + to_string(scale);
      }
      if (told.error > 1e-9 * (1 + told.value)) return "a useless error";
      const auto [a0, a1, a2] = index.area_polynomial(index.place(scale).interval);
      if (a0 + scale * (a1 + scale * a2) != exact) return "the polynomial at " + to_string(scale);
      const auto features = index.features(scale);
      if (features.components != sum.components || features.holes != sum.holes) {
        return "the features at " + to_string(scale);
      }
    }
    return "";
  });
}

/// A comb of `teeth`, none like another.
PolygonSet comb(int teeth, bool upright) {
  Ring ring{{-40, -100}, {100 * teeth, -100}, {100 * teeth, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    const int left = 100 * k + 3 * (k * k % 7), height = 900 + 37 * (k * k % 11);
    ring.push_back({left + 50, 0});
    ring.push_back({left + 41 - k % 3, height + 5});
    ring.push_back({left + 9 + k % 4, height});
    ring.push_back({left, 0});
  }
  ring.push_back({-40, 0});
  if (upright) {
    for (Point& p : ring) p = {-p.y, p.x};
  }
  return {{{ring, {}}}};
}

TEST(ScaleIndex, PatchesWithManyNodesAreCutDownToWhereTheBoundaryIs) {
  const PolygonSet P = comb(15, false), Q = comb(15, true);
  const ScaleIndex index(P, Q, {Rational(2, 3), Rational(3, 2)});
  std::vector<Rational> scales{Rational(2, 3), Rational(97, 101), 1, Rational(113, 89),
                               Rational(3, 2)};
  const auto [first, last] = index.events_within();
  ASSERT_LT(first + 3, last);
  for (std::uint32_t k = first; k < last; ++k) scales.push_back(index.event(k));
  for (const Rational& scale : scales) {
    EXPECT_EQ(index.sum(scale).region, minkowski_sum(P, Q, scale).region) << to_string(scale);
  }
}

TEST(ScaleIndex, OfACombWithItselfInEveryPosition) {
  for (int teeth = 2; teeth <= 9; ++teeth) {
    for (const bool upright : {false, true}) {
      const PolygonSet P = comb(teeth, false), Q = comb(teeth, upright);
      const ScaleIndex index(P, Q, {Rational(1, 3), 3});
      std::vector<Rational> scales{Rational(1, 3), 1, Rational(101, 100), 3};
      const auto [first, last] = index.events_within();
      for (std::uint32_t k = first; k < last; k += 1 + (last - first) / 5) {
        scales.push_back(index.event(k));
      }
      for (const Rational& scale : scales) {
        EXPECT_EQ(index.sum(scale).region, minkowski_sum(P, Q, scale).region)
            << teeth << " teeth at " << to_string(scale);
      }
    }
  }
}

TEST(ScaleIndex, ANodeThatBeginsWhereItsPatchIsCutIsNotKeptForThatScaleOnly) {
  // The same comb's teeth twice: nodes begin and end at 1, where cells are cut too.
  const PolygonSet P = {{{{{100000, -100000}, {100000, 1000000}, {0, 1000000}, {0, 908760},
                           {-586879, 881656}, {-581068, 826996}, {0, 793803},  {0, 701791},
                           {-648809, 687627}, {-642385, 610969}, {0, 604162},  {0, 503705},
                           {-652408, 488642}, {-645949, 422023}, {0, 396389},  {0, 294635},
                           {-567680, 287791}, {-562059, 216913}, {0, 203028},  {0, 93685},
                           {-652279, 89973},  {-645821, 10472},  {0, -7193},   {0, -100000}},
                          {}}}};
  const ScaleIndex index(P, P, {Rational(1, 4), 4});
  for (const Rational& scale :
       {Rational(1, 3), Rational(255, 256), Rational(1), Rational(257, 256)}) {
    EXPECT_EQ(index.sum(scale).region, minkowski_sum(P, P, scale).region) << to_string(scale);
  }
}

TEST(ScaleIndex, CoordinatesBelowAllDoublesAreWithinTheErrors) {
  Rational tiny = 1;
  for (int k = 0; k < 400; ++k) tiny /= 10;
  const PolygonSet P{{{{{0, 0}, {tiny, 0}, {0, tiny}}, {}}}};
  const ScaleIndex index(P, P, {Rational(1), Rational(2)});
  RoundedRings rings;
  index.rings(Rational(3, 2), rings);
  const Rational error = from_double(rings.error);
  EXPECT_GE(error, tiny * 5 / 2);
  const auto area = index.area(Rational(3, 2));
  EXPECT_GE(from_double(area.error), abs(from_double(area.value) - tiny * tiny * 25 / 8));
}

TEST(ScaleIndex, OfTheEmptySetIsEmpty) {
  const ScaleIndex index({}, box(0, 0, 1, 1), {Rational(1, 2), Rational(3)});
  EXPECT_TRUE(index.sum(1).region.empty());
  EXPECT_EQ(index.area(1).value, 0);
  EXPECT_EQ(index.features(1).components, 0U);
  EXPECT_TRUE(index.timeline().topology.empty());
}

TEST(ScaleIndex, RefusesOperandsWithoutASum) {
  EXPECT_THROW(ScaleIndex(point_set(0, 0), segment_set({0, 0}, {1, 0}), {}), BadInput);
  EXPECT_THROW(ScaleIndex(box(0, 0, 1, 1), box(0, 0, 1, 1), {Rational(2), Rational(1)}), BadInput);
}

TEST(ScaleIndex, KeepsItsMemoryLimitAndTellsItsProgress) {
  const PolygonSet P = box(0, 0, 1, 1), Q = box(0, 0, 2, 1);
  std::size_t calls = 0;
  BuildOptions options;
  options.progress = [&](const BuildProgress& p) {
    EXPECT_LE(p.done, p.total);
    ++calls;
  };
  const ScaleIndex index(P, Q, {Rational(1), Rational(2)}, options);
  EXPECT_GT(calls, 4U);
  options.memory_limit = 1;
  try {
    const ScaleIndex too_large(P, Q, {Rational(1), Rational(2)}, options);
    FAIL() << "no refusal";
  } catch (const LimitExceeded& refusal) {
    EXPECT_EQ(refusal.code(), "memory-limit");
  }
}

TEST(ScaleIndex, HoldsNoScaleOutsideItsWindow) {
  const ScaleIndex index(box(0, 0, 1, 1), box(0, 0, 2, 1), {Rational(1, 2), Rational(3)});
  EXPECT_THROW(index.sum(Rational(1, 3)), BadInput);
  EXPECT_THROW(index.sum(4), BadInput);
  EXPECT_THROW(index.sum(0), BadInput);
  EXPECT_EQ(index.sum(3).region, minkowski_sum(box(0, 0, 1, 1), box(0, 0, 2, 1), 3).region);
}

}  // namespace
}  // namespace minkref::testing::of_scale_index
