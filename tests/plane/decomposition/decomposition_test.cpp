// Cuts at notches, and pieces: laws on random sets, and cases worked out by hand.
#include <gtest/gtest.h>

#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/decomposition/cut_pieces.hpp"
#include "reference/plane/location.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_decomposition {
namespace {

using Ends = std::vector<std::pair<Point, Point>>;

Ends ends(const NotchCuts& cuts) {
  Ends found;
  for (const NotchCut& cut : cuts.cuts) found.emplace_back(cut.from, cut.to);
  return found;
}

std::vector<PolygonSet> regions_of(const std::vector<CutPiece>& pieces) {
  std::vector<PolygonSet> found;
  for (const CutPiece& piece : pieces) found.push_back(piece.region);
  return found;
}

bool is_convex(const PolygonSet& set) {
  if (set.polygons.size() != 1 || !set.polygons[0].holes.empty()) return false;
  const Ring& ring = set.polygons[0].outer;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (sign(cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n])) <= 0) {
      return false;
    }
  }
  return true;
}

/// Random notches, shuffled.
std::vector<Point> some(Source& random, std::vector<Point> notches) {
  std::vector<Point> kept;
  while (!notches.empty()) {
    const std::size_t k = random.below(notches.size());
    if (random.below(3) != 0) kept.push_back(notches[k]);
    notches.erase(notches.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return kept;
}

std::string wrong_tiling(const PolygonSet& P, const std::vector<CutPiece>& pieces) {
  const std::vector<PolygonSet> sets = regions_of(pieces);
  Rational total = 0;
  for (const PolygonSet& piece : sets) {
    if (!is_valid(piece) || piece != canonicalize(piece).region) return "a piece in another form";
    if (canonicalize(piece).components != 1) return "a piece in parts";
    total += area(piece);
  }
  if (total != area(P)) return "areas do not add up";
  if (combined(SetOperation::unite, sets).region != canonicalize(P).region) return "another union";
  return "";
}

std::string wrong_law(const PolygonSet& P, const std::vector<Point>& notches) {
  const NotchCuts cuts = notch_cuts(P, notches);
  const std::vector<CutPiece> pieces = cut_pieces(cuts);
  for (const auto& [a, b] : ends(cuts)) {
    for (int k = 1; k < 4; ++k) {
      const Point between{a.x + (b.x - a.x) * k / 4, a.y + (b.y - a.y) * k / 4};
      if (locate(P, between) != Location::inside) return "a cut outside";
    }
  }
  if (pieces.size() > cuts.cuts.size() + canonicalize(P).components) return "too many pieces";
  std::vector<Point> all = notches;
  const std::size_t before = cuts.cuts.size();
  all.insert(all.end(), notches.begin(), notches.end());
  if (notch_cuts(P, all).cuts.size() != before) return "a notch that its cut does not resolve";
  return wrong_tiling(P, pieces);
}

/// Small pieces of lattices with touching rings, and larger sets.
Case shapes(Source& random) {
  return {random.coin() ? random_mesh_region(random, 5) : random_region(random, 3), {}, 1};
}

TEST(Decomposition, PiecesTileTheSetForAnyNotchesInAnyOrder) {
  MINKREF_SEEDED(random, 820);
  std::size_t slits = 0;
  expect_law(random, 200, shapes, [&](const Case& c) {
    const std::vector<Point> notches = some(random, reflex_vertices(c.P));
    for (const CutPiece& piece : cut_pieces(notch_cuts(c.P, notches))) slits += piece.slits.size();
    return wrong_law(c.P, notches);
  });
  EXPECT_GT(slits, 0U);
}

TEST(Decomposition, AllPiecesAreConvexAfterCutsAtAllReflexVertices) {
  MINKREF_SEEDED(random, 821);
  expect_law(random, 200, shapes, [](const Case& c) -> std::string {
    const std::vector<Point> notches = reflex_vertices(c.P);
    for (const CutPiece& piece : cut_pieces(notch_cuts(c.P, notches))) {
      if (!is_convex(piece.region) || !piece.slits.empty()) return "a piece is not convex";
    }
    return wrong_law(c.P, notches);
  });
}

TEST(Decomposition, OfTwoPiecesTheInteriorsAreDisjoint) {
  MINKREF_SEEDED(random, 822);
  expect_law(random, 30, shapes, [](const Case& c) -> std::string {
    const std::vector<CutPiece> pieces = cut_pieces(notch_cuts(c.P, reflex_vertices(c.P)));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Canonical shared =
            combined(SetOperation::intersect, {pieces[i].region, pieces[j].region});
        if (!shared.region.empty()) return "two pieces overlap";
      }
    }
    return "";
  });
}

TEST(Decomposition, DoesNotDependOnHowTheSetIsWritten) {
  MINKREF_SEEDED(random, 823);
  expect_law(random, 150, shapes, [](const Case& c) -> std::string {
    const std::vector<Point> notches = reflex_vertices(c.P);
    PolygonSet other = c.P;
    std::reverse(other.polygons.begin(), other.polygons.end());
    for (Polygon& polygon : other.polygons) {
      std::reverse(polygon.holes.begin(), polygon.holes.end());
      std::rotate(polygon.outer.begin(), polygon.outer.begin() + 1, polygon.outer.end());
      const Point middle{(polygon.outer[0].x + polygon.outer[1].x) / 2,
                         (polygon.outer[0].y + polygon.outer[1].y) / 2};
      polygon.outer.insert(polygon.outer.begin() + 1, middle);  // a straight vertex
    }
    if (reflex_vertices(other) != notches) return "other notches";
    const NotchCuts cuts = notch_cuts(c.P, notches), of_other = notch_cuts(other, notches);
    if (ends(cuts) != ends(of_other)) return "other cuts";
    return regions_of(cut_pieces(cuts)) == regions_of(cut_pieces(of_other)) ? "" : "other pieces";
  });
}

/// x -> f (a, b; -b, a) x + t.
PolygonSet moved(const PolygonSet& set, const Point& by, const Point& t) {
  return mapped(set, [&](const Point& p) {
    return Point{p.x * by.x - p.y * by.y + t.x, p.x * by.y + p.y * by.x + t.y};
  });
}

std::string wrong_image(const PolygonSet& P, const Point& by, const Point& t) {
  const auto image = [&](const Point& p) {
    return moved(point_set(p.x, p.y), by, t).polygons[0].outer[0];
  };
  std::vector<Point> notches = reflex_vertices(P);
  const Ends cuts = ends(notch_cuts(P, notches));
  for (Point& notch : notches) notch = image(notch);
  Ends expected;
  for (const auto& [a, b] : cuts) expected.emplace_back(image(a), image(b));
  return ends(notch_cuts(moved(P, by, t), notches)) == expected ? "" : "other cuts";
}

TEST(Decomposition, CommutesWithScalingAndTranslationTiesIncluded) {
  MINKREF_SEEDED(random, 824);
  const Rational vast = parse_rational("1e400"), tiny = parse_rational("1e-400");
  expect_law(random, 60, shapes, [&](const Case& c) -> std::string {
    for (const Rational& factor : {vast, tiny, Rational(7, 3)}) {
      const std::string wrong = wrong_image(c.P, {factor, 0}, {Rational(1, 3) * factor, -factor});
      if (!wrong.empty()) return wrong;
    }
    return wrong_image(c.P, {1, 0}, {parse_rational("1e30"), Rational(1, 7)});
  });
}

TEST(Decomposition, CommutesWithRotationWhereNoTwoEndsAreAsNear) {
  MINKREF_SEEDED(random, 825);
  expect_law(random, 100, shapes, [&](const Case& c) {
    PolygonSet P = shaken(random, c.P, 20);
    if (!is_valid(P)) return std::string();
    return wrong_image(P, {Rational(3, 5), Rational(4, 5)}, {1, 2});
  });
}

TEST(Decomposition, OfTwoNearestEndsTheLeastIsTaken) {
  const PolygonSet L = region({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  EXPECT_EQ(ends(notch_cuts(L, reflex_vertices(L))), (Ends{{{1, 1}, {0, 1}}}));
}

TEST(Decomposition, ACutToAnotherNotchResolvesBoth) {
  const PolygonSet waist = region({{-3, -3}, {0, -1}, {3, -3}, {3, 3}, {0, 1}, {-3, 3}});
  const NotchCuts cuts = notch_cuts(waist, reflex_vertices(waist));
  EXPECT_EQ(ends(cuts), (Ends{{{0, -1}, {0, 1}}}));
  EXPECT_EQ(cut_pieces(cuts).size(), 2U);
}

TEST(Decomposition, ACutToAnotherNotchMayLeaveItReflex) {
  // From (0,-1) up to (0,1), whose other side still has more than half a turn.
  const PolygonSet set = region({{-3, -3}, {0, -1}, {3, -3}, {3, 1}, {0, 1}, {1, 3}, {-3, 3}});
  const NotchCuts cuts = notch_cuts(set, {{0, -1}, {0, 1}});
  ASSERT_EQ(cuts.cuts.size(), 2U);
  EXPECT_EQ(ends(cuts)[0], (std::pair<Point, Point>{{0, -1}, {0, 1}}));
  for (const CutPiece& piece : cut_pieces(cuts)) EXPECT_TRUE(is_convex(piece.region));
}

TEST(Decomposition, ACutFromAHoleIsASlitUntilAnotherOneMeetsTheRing) {
  const PolygonSet ring = region(rectangle(0, 0, 9, 9), {rectangle(2, 3, 6, 5)});
  const std::vector<CutPiece> one = cut_pieces(notch_cuts(ring, {{2, 3}}));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].region, canonicalize(ring).region);
  EXPECT_EQ(one[0].slits, (Ends{{{2, 3}, {0, 3}}}));
  const std::vector<CutPiece> two = cut_pieces(notch_cuts(ring, {{2, 3}, {6, 5}}));
  EXPECT_EQ(two.size(), 2U);
  for (const CutPiece& piece : two) EXPECT_TRUE(piece.slits.empty());
}

/// A room with a spike from below and one from the left.
PolygonSet spiked() {
  return region(
      {{0, 0}, {9, 0}, {10, 1}, {11, 0}, {20, 0}, {20, 10}, {0, 10}, {0, 6}, {5, 5}, {0, 4}});
}

TEST(Decomposition, AnEarlierCutIsAWall) {
  const NotchCuts cuts = notch_cuts(spiked(), {{10, 1}, {5, 5}});
  EXPECT_EQ(ends(cuts), (Ends{{{10, 1}, {10, 10}}, {{5, 5}, {10, 5}}}));
  EXPECT_EQ(cuts.cuts[1].wall, cuts.boundary.edges.size());
  EXPECT_EQ(cut_pieces(cuts).size(), 3U);
  const NotchCuts other = notch_cuts(spiked(), {{5, 5}, {10, 1}});
  EXPECT_EQ(ends(other), (Ends{{{5, 5}, {20, 5}}, {{10, 1}, {10, 5}}}));
}

TEST(Decomposition, PartsOfACutAreSlitsByThemselves) {
  const PolygonSet room =
      region(rectangle(0, 0, 20, 10), {{{9, 2}, {11, 2}, {10, 3}}, {{3, 4}, {5, 5}, {3, 6}}});
  const std::vector<CutPiece> one = cut_pieces(notch_cuts(room, {{10, 3}, {5, 5}}));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].slits, (Ends{{{10, 3}, {10, 5}}, {{10, 5}, {10, 10}}, {{5, 5}, {10, 5}}}));
  const std::vector<CutPiece> two = cut_pieces(notch_cuts(room, {{10, 3}, {5, 5}, {9, 2}}));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].slits, (Ends{{{5, 5}, {10, 5}}}));
  EXPECT_TRUE(two[1].slits.empty());
  EXPECT_EQ(wrong_tiling(room, two), "");
}

TEST(Decomposition, ACutMayRunOnWhereAnEarlierOneEnds) {
  // Both notches lie on y = 2, and the prolongation of either's wall is the way to the other.
  const PolygonSet bone = region({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 0}, {6, 0}, {6, 6}, {0, 6}});
  const NotchCuts cuts = notch_cuts(bone, reflex_vertices(bone));
  EXPECT_EQ(ends(cuts), (Ends{{{2, 2}, {0, 2}}, {{4, 2}, {6, 2}}}));
  EXPECT_EQ(cut_pieces(cuts).size(), 3U);
}

TEST(Decomposition, RingsThatTouchHaveASectorEach) {
  // The hole's corner (4,0) lies within the lowest edge; (4,0) has two sectors, both convex.
  const PolygonSet touched = region(rectangle(0, 0, 9, 9), {{{4, 0}, {5, 4}, {3, 4}}});
  const std::vector<Point> notches = reflex_vertices(touched);
  EXPECT_EQ(notches, (std::vector<Point>{{3, 4}, {5, 4}}));
  const NotchCuts cuts = notch_cuts(touched, {{4, 0}, {3, 4}, {5, 4}});
  EXPECT_EQ(cuts.cuts.size(), 2U);
  EXPECT_EQ(cuts.cuts[0].notch, 1U);
  EXPECT_EQ(wrong_tiling(touched, cut_pieces(cuts)), "");
}

TEST(Decomposition, SetsThatTouchAtAPointStayPieces) {
  const PolygonSet both = testing::together(box(0, 0, 1, 1), box(1, 1, 2, 2));
  EXPECT_TRUE(reflex_vertices(both).empty());
  EXPECT_EQ(cut_pieces(notch_cuts(both, {{1, 1}})).size(), 2U);
}

TEST(Decomposition, PointsAndSegmentsHaveNoPieces) {
  for (const PolygonSet& thin : {point_set(1, 2), segment_set({0, 0}, {3, 1}), PolygonSet{}}) {
    EXPECT_TRUE(reflex_vertices(thin).empty());
    EXPECT_TRUE(cut_pieces(notch_cuts(thin, {})).empty());
  }
}

TEST(Decomposition, RefusesANotchThatIsNoVertex) {
  try {
    notch_cuts(box(0, 0, 4, 4), {{1, 2}});
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_EQ(error.code(), "no-notch");
  }
}

}  // namespace
}  // namespace minkref::testing::of_decomposition
