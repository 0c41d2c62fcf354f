// The law that lets one point of a face stand for all (docs/scale-index.md): no point of an exposed
// piece lies in the sum of the interiors.
#include <gtest/gtest.h>

#include <array>

#include "reference/plane/index/piece_track.hpp"
#include "reference/plane/index/swept_boundary.hpp"
#include "reference/plane/moving/interior_test.hpp"
#include "reference/plane/moving/right_of_edge.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/random_cases.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_exposed_pieces {
namespace {

const std::array<Rational, 3> odd_shares{Rational(311, 997), Rational(419, 997),
                                         Rational(733, 997)};

/// Tests three points of each piece, away from all middles.
std::string fault_of_pieces(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                            std::size_t& asked) {
  const SweptBoundary boundary = swept_boundary(P, Q, window);
  const InteriorTest test(P, Q);
  for (const ExposedPiece& piece : boundary.pieces) {
    const Rational upper = piece.upper.value_or(2 * piece.lower + 1);
    const Track from = track_of(boundary, piece.edge, piece.from),
                to = track_of(boundary, piece.edge, piece.to);
    for (std::size_t k = 0; k < odd_shares.size(); ++k) {
      const Rational scale = piece.lower + (upper - piece.lower) * odd_shares[k];
      const Rational& share = odd_shares[(k + 1) % odd_shares.size()];
      const Point a = from.at(scale), b = to.at(scale);
      const Point x{a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
      ++asked;
      if (test.inside(x, scale)) {
        return "edge " + std::to_string(piece.edge) + " at (" + to_string(x.x) + ", " +
               to_string(x.y) + "), scale " + to_string(scale) + "\n" + text(P) + text(Q);
      }
    }
  }
  return "";
}

/// Frames with one-cell holes, chosen from a chessboard with three rows, and the same cells as
/// parts.
std::vector<PolygonSet> chessboards() {
  std::vector<PolygonSet> sets;
  for (unsigned chosen = 0; chosen < 32; ++chosen) {
    std::vector<Ring> cells;
    for (unsigned k = 0; k < 5; ++k) {
      const long x = 2 * k % 3, y = 2 * k / 3;
      if (chosen >> k & 1U) cells.push_back(rectangle(x, y, x + 1, y + 1));
    }
    if (cells.size() < 2) continue;
    PolygonSet parts;
    for (const Ring& cell : cells) parts.polygons.push_back({cell, {}});
    sets.push_back(parts);
    sets.push_back(region(rectangle(-1, -1, 4, 4), cells));
  }
  return sets;
}

TEST(ExposedPieces, HaveNoPointInsideBesideASegment) {
  std::size_t asked = 0;
  const std::vector<ScaleWindow> windows{{}, {Rational(1), Rational(2)}};
  const std::vector<PolygonSet> sets = chessboards();
  for (std::size_t k = 0; k < sets.size(); k += 5) {
    for (const Point& way : {Point{1, 1}, Point{2, 1}}) {
      for (const ScaleWindow& window : windows) {
        ASSERT_EQ(fault_of_pieces(segment_set({0, 0}, way), sets[k], window, asked), "");
      }
    }
  }
  EXPECT_GT(asked, 1'000U);
}

TEST(ExposedPieces, HaveNoPointInsideOfRegions) {
  MINKREF_SEEDED(random, 905);
  std::size_t asked = 0;
  expect_law(random, 8, [&](const Case& c) {
    return fault_of_pieces(c.P, c.Q, {}, asked) +
           fault_of_pieces(c.P, c.Q, {c.scale / 2, c.scale * 2}, asked);
  });
  const std::vector<PolygonSet> sets = chessboards();
  for (std::size_t k = 0; k + 7 < sets.size(); k += 6) {
    ASSERT_EQ(fault_of_pieces(sets[k], sets[k + 7], {Rational(2, 3), Rational(3, 2)}, asked), "");
  }
  EXPECT_GT(asked, 500U);
}

TEST(ExposedPieces, PassagesHideOnlyWhereBothOperandsHaveTwoSides) {
  const PolygonSet segment = segment_set({0, 0}, {2, 1}), square = box(0, 0, 1, 1),
                   point = point_set(0, 0), touching = together(box(0, 0, 1, 1), box(1, 1, 2, 2)),
                   holed = region(rectangle(0, 0, 4, 4), {Ring{{0, 2}, {1, 3}, {2, 2}, {1, 1}}});
  for (const PolygonSet& other : {touching, holed}) {
    EXPECT_TRUE(may_hide_passages(segment, other));
    EXPECT_TRUE(may_hide_passages(other, segment));
    EXPECT_TRUE(may_hide_passages(other, touching));
    EXPECT_FALSE(may_hide_passages(point, other));
    EXPECT_FALSE(may_hide_passages(other, square));
  }
  EXPECT_FALSE(may_hide_passages(segment, square));
  EXPECT_FALSE(may_hide_passages({}, touching));
}

TEST(ExposedPieces, TheSumIsAskedBesideAPoint) {
  const InteriorTest squares(box(0, 0, 1, 1), box(0, 0, 1, 1));
  EXPECT_TRUE(squares.in_sum_beside({2, 1}, {-1, 0}, 1));
  EXPECT_TRUE(squares.in_sum_beside({2, 1}, {0, 1}, 1));  // along the side
  EXPECT_FALSE(squares.in_sum_beside({2, 1}, {1, 0}, 1));
  EXPECT_FALSE(squares.in_sum_beside({2, 2}, {0, 1}, 1));
  EXPECT_TRUE(squares.in_sum_beside({1, 1}, {1, 1}, 1));
  EXPECT_FALSE(squares.in_sum_beside({5, 5}, {-1, -1}, 1));
  const InteriorTest swept(segment_set({0, 0}, {2, 0}), box(0, 0, 1, 1));
  EXPECT_TRUE(swept.in_sum_beside({2, 1}, {0, -1}, 1));
  EXPECT_FALSE(swept.in_sum_beside({2, 1}, {0, 1}, 1));
  EXPECT_TRUE(swept.in_sum_beside({3, 1}, {-1, 0}, 1));
  EXPECT_FALSE(swept.in_sum_beside({3, 1}, {1, 0}, 1));
  const InteriorTest copy(box(0, 0, 1, 1), point_set(3, 3));
  EXPECT_TRUE(copy.in_sum_beside({4, 4}, {-1, -1}, 1));
  EXPECT_FALSE(copy.in_sum_beside({4, 4}, {-1, 1}, 1));
}

}  // namespace
}  // namespace minkref::testing::of_exposed_pieces
