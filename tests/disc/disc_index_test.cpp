// At any radius, the region read off the index is the static sum, and the history's counts are the
// static sum's counts.
#include "reference/disc/index/disc_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/disc/index/index_measures.hpp"
#include "reference/disc/index/index_region.hpp"
#include "reference/disc/index/radius_level.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/number/radicals/polynomial.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_disc_index {
namespace {

struct Built {
  explicit Built(const PolygonSet& set)
      : P(set), index(set), history(offset_history(index)), curves(offset_curves(set)) {}

  Rational low(std::uint32_t gap) const {
    return gap == 0 ? Rational(0) : Rational(radius(gap - 1).upper());
  }
  Rational high(std::uint32_t gap) const {
    return gap == index.radii() ? Rational(low(gap) * 2 + 1) : Rational(radius(gap).lower());
  }
  Interval radius(std::uint32_t number) const {
    return index.diagram().radius(index.diagram().events[index.event_at(number)]);
  }

  PolygonSet P;
  DiscIndex index;
  OffsetHistory history;
  OffsetCurves curves;
};

std::size_t components(const OffsetRegion& region) { return region.components.size(); }

/// Each vertex starts a piece, within the known bounds.
void expect_vertices(const Built& built, std::uint32_t gap, double radius,
                     const OffsetRegion& expected) {
  IndexBoundary boundary;
  built.index.boundary(gap, boundary);
  std::vector<BoundedPoint> found;
  std::vector<std::uint32_t> starts;
  built.index.vertices(boundary, radius, found, starts);
  std::size_t rings = 0;
  for (const OffsetComponent& component : expected.components) rings += 1 + component.holes.size();
  EXPECT_EQ(starts.size(), rings);
  for (const BoundedPoint& vertex : found) {
    EXPECT_LT(vertex.error, 1e-10);
    const Interval x(vertex.x - vertex.error, vertex.x + vertex.error),
        y(vertex.y - vertex.error, vertex.y + vertex.error);
    const auto& pieces = expected.offset.pieces;
    const bool is_there = std::any_of(pieces.begin(), pieces.end(), [&](const OffsetPiece& piece) {
      const auto at = expected.offset.at->position(piece.patch, piece.from);
      return (at.x - x).contains_zero() && (at.y - y).contains_zero();
    });
    EXPECT_TRUE(is_there) << vertex.x << ", " << vertex.y;
  }
}

void check_gaps(const Built& built, testing::Source& random, int most) {
  const IndexRegions regions(built.index, built.history, built.curves);
  for (int k = 0; k < most; ++k) {
    const auto gap =
        static_cast<std::uint32_t>(random.between(0, static_cast<int>(built.index.radii())));
    const Rational low = built.low(gap), high = built.high(gap);
    if (low >= high) continue;
    const Rational radius = from_double(to_double(low + (high - low) * random.between(1, 9) / 10));
    if (radius <= low || radius >= high) continue;
    const DiscIndex::Place place = built.index.place(radius * radius);
    ASSERT_EQ(place.gap, gap);
    ASSERT_FALSE(place.at_event);
    const OffsetRegion expected = offset_region(built.P, radius * radius);
    const IndexRegion found = regions.at(gap);
    ASSERT_EQ(canonical_json(found.form, built.curves, radius * radius), canonical_json(expected));
    ASSERT_EQ(found.holes, expected.holes);
    ASSERT_EQ(built.history.holes(place), expected.holes);
    ASSERT_EQ(built.history.components(place), components(expected));
    const OffsetMeasures told = IndexMeasures(built.index).at(place, radius * radius);
    const OffsetMeasures right = measures(expected);
    ASSERT_TRUE((told.area - right.area).contains_zero());
    ASSERT_TRUE((told.length - right.length).contains_zero());
    ASSERT_LT(told.area.upper() - told.area.lower(), 1e-9 * told.area.upper());
    ASSERT_LT(told.length.upper() - told.length.lower(), 1e-9 * told.length.upper());
    ASSERT_NO_FATAL_FAILURE(expect_vertices(built, gap, to_double(radius), expected));
  }
}

/// Compares at event radii whose squares are rational.
std::size_t check_events(const Built& built) {
  std::size_t looked_at = 0;
  const DiagramEvents& diagram = built.index.diagram();
  for (std::uint32_t k = 0; k < built.index.radii(); ++k) {
    const RootNumber square = diagram.exact(diagram.events[built.index.event_at(k)]).squared_radius;
    const Polynomial polynomial = without_multiple_roots(square.polynomial());
    if (polynomial.size() != 2) continue;
    ++looked_at;
    const OffsetRegion expected = offset_region(built.P, -polynomial[0]);
    const DiscIndex::Place place = built.index.place(-polynomial[0]);
    EXPECT_TRUE(place.at_event);
    EXPECT_EQ(place.gap, k + 1);
    EXPECT_EQ(built.history.holes(place), expected.holes) << k;
    EXPECT_EQ(built.history.components(place), components(expected)) << k;
  }
  return looked_at;
}

TEST(DiscIndex, IsTheStaticSumInGaps) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const Built built(seed % 2 == 0 ? testing::random_region(random, 4)
                                    : testing::random_mesh_region(random, 5));
    ASSERT_NO_FATAL_FAILURE(check_gaps(built, random, 6));
  }
}

/// Diamonds touch a frame's sides from either side: less than half a turn stays free there.
TEST(DiscIndex, WhereVerticesTouchEdges) {
  std::size_t looked_at = 0;
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    PolygonSet P{{{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{{2, 2}, {2, 18}, {18, 18}, {18, 2}}}}}};
    for (int k = random.between(1, 5); k > 0; --k) {
      const Rational r = Rational(random.between(1, 6)) / 2,
                     t = Rational(random.between(8, 32)) / 2;
      const Rational far = random.coin() ? (random.coin() ? 20 + r : Rational(-r))
                                         : (random.coin() ? Rational(18 - r) : 2 + r);
      const Point at = random.coin() ? Point{far, t} : Point{t, far};
      P.polygons.push_back(
          {{{at.x - r, at.y}, {at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}}, {}});
    }
    if (!testing::is_valid(P)) continue;
    ++looked_at;
    ASSERT_NO_FATAL_FAILURE(check_gaps(Built(P), random, 6));
  }
  EXPECT_GE(looked_at, testing::repetitions(20U));
}

TEST(DiscIndex, HasTheCountsAtEvents) {
  std::size_t looked_at = 0;
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    looked_at += check_events(Built(testing::random_mesh_region(random, 5)));
  }
  EXPECT_GE(looked_at, testing::repetitions(100U));
}

/// A bound of 0 at a radius below the range of doubles was no bound.
TEST(DiscIndex, HasBoundsAtRadiiOfAllMagnitudes) {
  const Rational third(1, 3);
  const Built built({{{{{0, 0}, {third, 0}, {third, third}, {0, third}}, {}}}});
  for (const double radius : {0x1p-1073, 1e-320, 1e-300, 0.1, 7.0, 1e300}) {
    const Rational r = from_double(radius), over = third + r;
    const std::vector<Point> expected{{0, -r},       {third, -r}, {over, 0},   {over, third},
                                      {third, over}, {0, over},   {-r, third}, {-r, 0}};
    IndexBoundary boundary;
    built.index.boundary(0, boundary);
    std::vector<BoundedPoint> found;
    std::vector<std::uint32_t> starts;
    built.index.vertices(boundary, radius, found, starts);
    ASSERT_EQ(found.size(), expected.size());
    for (const Point& vertex : expected) {
      const auto is_near = [&](double x, const Rational& y, double error) {
        return abs(Rational(from_double(x) - y)) <= from_double(error);
      };
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const BoundedPoint& p) {
                                return is_near(p.x, vertex.x, p.error) &&
                                       is_near(p.y, vertex.y, p.error);
                              }))
          << radius << ": " << vertex.x << ", " << vertex.y;
    }
  }
}

TEST(DiscIndex, OfAPointASegmentAndNothing) {
  for (const PolygonSet& P : {PolygonSet{{{{{1, 2}}, {}}}}, PolygonSet{{{{{0, 0}, {3, 4}}, {}}}},
                              PolygonSet{}, PolygonSet{{{{{0, 0}, {3, 0}, {1, 2}}, {}}}}}) {
    const Built built(P);
    EXPECT_EQ(built.index.radii(), 0U);
    const IndexRegion region = IndexRegions(built.index, built.history, built.curves).at(0);
    EXPECT_EQ(canonical_json(region.form, built.curves, 2), canonical_json(offset_region(P, 2)));
    const OffsetMeasures told = IndexMeasures(built.index).at({0, false}, 2);
    const OffsetMeasures right = measures(offset_region(P, 2));
    EXPECT_TRUE((told.area - right.area).contains_zero());
    EXPECT_TRUE((told.length - right.length).contains_zero());
  }
}

/// A square frame: its hole ends at the radius that reaches the middle.
TEST(DiscIndex, FollowsAHole) {
  const Ring outer{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, hole{{2, 2}, {2, 6}, {6, 6}, {6, 2}};
  const Built built(PolygonSet{{{outer, {hole}}}});
  ASSERT_EQ(built.history.all_holes.size(), 1U);
  EXPECT_EQ(built.history.all_holes[0].birth, 0U);
  EXPECT_EQ(built.history.all_holes[0].from, 0U);
  const DiagramEvents& diagram = built.index.diagram();
  EXPECT_EQ(diagram.exact(diagram.events[built.history.all_holes[0].ends_at]).squared_radius,
            RootNumber(4));
}

/// A hole with two chambers of different width: the narrower chamber leaves the hole and ends
/// first. Its largest disc leans on the door's corners.
TEST(DiscIndex, NamesTheHoleThatEndsLast) {
  const Ring outer{{0, 0}, {40, 0}, {40, 20}, {0, 20}};
  const Ring hole{{2, 2},   {2, 18}, {18, 18}, {18, 11}, {20, 11}, {20, 16},
                  {30, 16}, {30, 4}, {20, 4},  {20, 9},  {18, 9},  {18, 2}};
  const Built built(PolygonSet{{{outer, {hole}}}});
  ASSERT_EQ(built.history.all_holes.size(), 2U);
  const OffsetHole &first = built.history.all_holes[0], &second = built.history.all_holes[1];
  EXPECT_EQ(first.birth, 0U);
  EXPECT_EQ(second.from, 1U);
  EXPECT_LT(second.end, first.end);
  const DiagramEvents& diagram = built.index.diagram();
  EXPECT_EQ(diagram.exact(diagram.events[second.born_at]).squared_radius, RootNumber(1));
  EXPECT_EQ(diagram.exact(diagram.events[second.ends_at]).squared_radius,
            RootNumber(Rational(10201, 400)));
  EXPECT_EQ(diagram.exact(diagram.events[first.ends_at]).squared_radius, RootNumber(64));
}

/// Two holes are born at the same radius, at which an outside corner is equally far from the boxes:
/// each is born at the door that cuts it off.
TEST(DiscIndex, PutsEachBirthAtItsOwnDoor) {
  const auto box = [](int x, int y, int high) {
    return Polygon{{{x, y}, {x + 1, y}, {x + 1, y + high}, {x, y + high}}, {}};
  };
  const Built built(PolygonSet{{box(16, 12, 1), box(15, 7, 1), box(11, 10, 3), box(19, 10, 1)}});
  ASSERT_EQ(built.history.all_holes.size(), 2U);
  const DiagramEvents& diagram = built.index.diagram();
  std::vector<RootPoint> places;
  for (const OffsetHole& hole : built.history.all_holes) {
    const auto place = diagram.exact(diagram.events[hole.born_at]);
    EXPECT_EQ(place.squared_radius, RootNumber(4));
    EXPECT_EQ(hole.from, 0U);
    places.push_back(place.at);
  }
  const auto is_born_at = [&](int x, int y) {
    return std::any_of(places.begin(), places.end(), [&](const RootPoint& at) {
      return are_same(at, {RootNumber(x), RootNumber(y)});
    });
  };
  EXPECT_TRUE(is_born_at(16, 10));
  EXPECT_TRUE(is_born_at(14, 12));
}

/// One door separates the three parts about it; each part of a row is cut off at a separate door; a
/// part between two doors at the first; a way to a single part cuts nothing off.
TEST(RadiusLevel, CutsOffPartsDoorByDoor) {
  using Ways = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  constexpr std::uint32_t outside = 7;
  RadiusLevel star(3);
  star.join(1, 2);
  for (const auto& [node, part] : Ways{{0, outside}, {1, outside}, {1, 8}, {2, 9}}) {
    star.lead(node, part);
  }
  ASSERT_EQ(star.groups().size(), 1U);
  EXPECT_EQ(star.cut_off(star.groups()[0], outside), (Ways{{8, 1}, {9, 2}}));
  RadiusLevel row(4);
  for (const auto& [node, part] : Ways{{3, outside}, {3, 8}, {1, 8}, {1, 9}, {0, 9}, {2, 8}}) {
    row.lead(node, part);
  }
  EXPECT_EQ(row.cut_off(row.groups()[0], outside), (Ways{{8, 3}, {9, 1}}));
  RadiusLevel around(2);
  for (const auto& [node, part] : Ways{{1, 8}, {1, outside}, {0, outside}, {0, 8}}) {
    around.lead(node, part);
  }
  EXPECT_EQ(around.cut_off(around.groups()[0], outside), (Ways{{8, 0}}));
  RadiusLevel greatest(2);
  EXPECT_EQ(greatest.groups().size(), 2U);
  EXPECT_TRUE(greatest.groups()[0].parts.empty());
}

/// Squares side by side join when their discs reach the middle, at that very radius.
TEST(DiscIndex, JoinsFacingSquares) {
  const Ring a{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, b{{4, 0}, {6, 0}, {6, 2}, {4, 2}};
  const Built built(PolygonSet{{{a, {}}, {b, {}}}});
  ASSERT_EQ(built.history.joins.size(), 1U);
  EXPECT_TRUE(built.history.joins[0].at_radius);
  EXPECT_EQ(built.history.components({0, false}), 2U);
  EXPECT_EQ(built.history.components({1, true}), 1U);
}

}  // namespace
}  // namespace minkref::of_disc_index
