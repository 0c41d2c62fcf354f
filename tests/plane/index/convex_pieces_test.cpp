// Convex pieces lie exactly inside their region.
#include "reference/plane/index/convex_pieces.hpp"

#include <gtest/gtest.h>

#include "reference/plane/moving/interior_test.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_convex_pieces {
namespace {

using Corner = std::array<double, 2>;

Point exact(const Corner& c) { return {from_double(c[0]), from_double(c[1])}; }

int side(const Point& a, const Point& b, const Point& c) {
  return sign(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

bool is_left_of_all(const Point& x, const std::vector<Point>& ring) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (side(ring[k], ring[(k + 1) % ring.size()], x) <= 0) return false;
  }
  return true;
}

/// The fault of a piece, if any: its corners must be inside, and no region edge may pass through
/// it.
std::string fault(const ConvexPiece& piece, const PolygonSet& region) {
  std::vector<Point> ring;
  for (const Corner& c : piece.corners) ring.push_back(exact(c));
  const std::size_t n = ring.size();
  if (n < 3) return "fewer than three corners";
  for (std::size_t k = 0; k < n; ++k) {
    if (side(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) <= 0) return "no turn to the left";
    if (!InteriorTest(region, point_set(0, 0)).inside(ring[k], 1)) return "a corner is outside";
  }
  const auto passes = [&](const Point& a, const Point& b) {
    if (is_left_of_all(a, ring) || is_left_of_all(b, ring)) return true;
    for (std::size_t k = 0; k < n; ++k) {
      const Point &u = ring[k], &v = ring[(k + 1) % n];
      if (side(a, b, u) * side(a, b, v) < 0 && side(u, v, a) * side(u, v, b) < 0) return true;
    }
    return false;
  };
  const auto look = [&](const Ring& boundary) {
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      if (passes(boundary[k], boundary[(k + 1) % boundary.size()])) return true;
    }
    return false;
  };
  for (const Polygon& polygon : region.polygons) {
    if (look(polygon.outer)) return "an edge passes";
    for (const Ring& hole : polygon.holes) {
      if (look(hole)) return "an edge of a hole passes";
    }
  }
  return "";
}

TEST(ConvexPieces, LieInTheInterior) {
  MINKREF_SEEDED(random, 921);
  std::uint64_t count = 0;
  expect_law(random, 60, [&](const Case& c) -> std::string {
    for (const std::size_t most_corners : {3U, 5U, 12U}) {
      for (const ConvexPiece& piece : convex_pieces(c.P, most_corners, 40)) {
        ++count;
        if (piece.corners.size() > most_corners) return "too many corners";
        const std::string why = fault(piece, c.P);
        if (!why.empty()) return why;
      }
    }
    return "";
  });
  EXPECT_GE(count, testing::repetitions(500U));
}

TEST(ConvexPieces, AConvexRegionIsOneOfAlmostItsArea) {
  const auto pieces = convex_pieces(box(-3, -1, 5, 1), 12, 40);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(pieces[0].area(), 16, 1e-5);
}

TEST(ConvexPieces, ALongBarIsNotCutAtTheSidesOfABoxAroundIt) {
  // A bar and a tooth on it: a piece of each reaches from end to end.
  PolygonSet comb;
  comb.polygons.push_back(
      {{{0, 0}, {100, 0}, {100, 1}, {51, 1}, {51, 40}, {50, 40}, {50, 1}, {0, 1}}, {}});
  double widest = 0, highest = 0;
  for (const ConvexPiece& piece : convex_pieces(comb, 12, 40)) {
    EXPECT_EQ(fault(piece, comb), "");
    widest = std::max(widest, piece.reach(1, 0) + piece.reach(-1, 0));
    highest = std::max(highest, piece.reach(0, 1) + piece.reach(0, -1));
  }
  EXPECT_GT(widest, 99);
  EXPECT_GT(highest, 39.9);
}

TEST(ConvexPieces, AHoleThatDoublesTakeForAPointIsInNone) {
  Rational tiny = 1;
  for (int k = 0; k < 80; ++k) tiny /= 2;
  PolygonSet region = box(-8, -8, 8, 8);
  region.polygons[0].holes.push_back({{3, 3}, {3, 3 + tiny}, {3 + tiny, 3 + tiny}, {3 + tiny, 3}});
  const auto pieces = convex_pieces(region, 12, 40);
  EXPECT_FALSE(pieces.empty());
  for (const ConvexPiece& piece : pieces) EXPECT_EQ(fault(piece, region), "");
}

TEST(ConvexPieces, OfCoordinatesBeyondDoublesThereAreNone) {
  Rational huge = 1;
  for (int k = 0; k < 1200; ++k) huge *= 2;
  for (const Rational& size : {huge, Rational(1 / huge)}) {
    PolygonSet region;
    region.polygons.push_back({{{0, 0}, {size, 0}, {0, size}}, {}});
    EXPECT_TRUE(convex_pieces(region, 12, 40).empty());
  }
}

}  // namespace
}  // namespace minkref::testing::of_convex_pieces
