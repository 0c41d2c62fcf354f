// Sums of flat faces with many corners: pieces and signs are counted, no time.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "reference/space/edges/edge_sum.hpp"
#include "reference/space/edges/flat_pieces.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_growth_of_sums_in_space {
namespace {

/// A comb with a thickness, whose teeth stand closer than a side of the box below.
Polyhedron comb_prism(int teeth) {
  std::vector<std::pair<int, int>> ring{{-20, -100}, {20 * teeth, -100}};
  for (int k = teeth - 1; k >= 0; --k) {
    for (const auto& [x, y] : {std::pair(9, 0), {9, 400}, {0, 400}, {0, 0}}) {
      ring.emplace_back(20 * k + x, y);
    }
  }
  Polyhedron result;
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (const int z : {0, 50}) {
    for (const auto& [x, y] : ring) result.vertices.push_back(bodies::at(x, y, z));
  }
  Face below, above;
  for (std::uint32_t k = 0; k < count; ++k) {
    below.push_back(count - 1 - k);
    above.push_back(count + k);
    const std::uint32_t next = (k + 1) % count;
    result.faces.push_back({k, next, count + next, count + k});
  }
  result.faces.push_back(below);
  result.faces.push_back(above);
  return result;
}

EdgeSum sum_with_a_box(int teeth) {
  return edge_sum(comb_prism(teeth), bodies::box(100, 100, 100), bodies::unit);
}

/// The diagonals of the comb's two caps cross all facets about them, and bear no edge.
TEST(GrowthOfSumsInSpace, DiagonalsOfAFlatFaceAreNotCut) {
  const EdgeSum sum = sum_with_a_box(24);
  EXPECT_EQ(sum.set.faces.size(), 10U);
  EXPECT_LT(sum.statistics.pieces, 2600U) << "of " << sum.facets << " facets";
}

/// A point over a flat face is held against none of the facets in the face's own plane.
TEST(GrowthOfSumsInSpace, PointsOverAFlatFaceTakeFewExactSigns) {
  const EdgeSum sum = sum_with_a_box(24);
  EXPECT_EQ(sum.statistics.tests, 230U);
  EXPECT_LT(sum.statistics.signs.by_integer, 80000U);
}

std::uint64_t signs(const EdgeSum& sum) {
  return sum.statistics.signs.by_float + sum.statistics.signs.by_integer;
}

/// Triangles of the caps are slivers from the comb's ends to each tooth, and cross what is near.
TEST(GrowthOfSumsInSpace, FlatFacesWithManyCornersCostAsMuchAsTheyHave) {
  const EdgeSum few = sum_with_a_box(100), many = sum_with_a_box(200);
  EXPECT_EQ(many.set.faces.size(), few.set.faces.size());
  EXPECT_LT(many.near_pairs, 2.2 * static_cast<double>(few.near_pairs));
  EXPECT_LT(many.statistics.pieces, 2.2 * static_cast<double>(few.statistics.pieces));
  EXPECT_LT(many.statistics.tests, 2.2 * static_cast<double>(few.statistics.tests));
  EXPECT_LT(signs(many), 2.4 * static_cast<double>(signs(few)));
}

/// Twice the area of a face's parts, as seen along its normal, times the normal's square.
template <class Corners>
Rational doubled_area(const IntegerVector& normal, const Corners& corners) {
  const auto from = corners(0);
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < corners.size; ++k) {
    const auto a = corners(k), b = corners(k + 1);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
      sum +=
          normal[i] * ((a[j] - from[j]) * (b[l] - from[l]) - (a[l] - from[l]) * (b[j] - from[j]));
    }
  }
  return sum;
}

/// Pieces have a positive area each, together that of the triangles, and hold each point once.
void expect_cover(const Polyhedron& body, std::mt19937& dice) {
  const SpaceOperands operands = space_operands(body, body, bodies::unit);
  const SpaceOperand& P = operands.P;
  const FlatPieces pieces = flat_pieces(P, 0);
  for (std::uint32_t f = 0; f < pieces.pieces.size(); ++f) {
    const auto& face = pieces.pieces[f];
    const IntegerVector& normal = P.triangles[face.triangle].normal.exact;
    Rational left = 0;
    std::vector<IntegerVector> points;
    for (std::uint32_t t = 0; t < pieces.face_of.size(); ++t) {
      if (pieces.face_of[t] != f) continue;
      struct {
        const SpaceOperand& P;
        const SpaceOperand::Triangle& triangle;
        std::size_t size = 3;
        std::array<Rational, 3> operator()(std::size_t k) const {
          const IntegerVector& p = P.points[triangle.corners[k]].exact;
          return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
        }
      } const corners{P, P.triangles[t]};
      left += doubled_area(normal, corners);
      IntegerVector point{0, 0, 0};  // times 1,000,000,007
      Integer rest = 1000000007;
      for (std::size_t k = 0; k < 3; ++k) {
        const Integer part = k == 2 ? rest : Integer(1 + dice() % 499999999);
        rest -= part;
        point = point + part * P.points[P.triangles[t].corners[k]].exact;
      }
      points.push_back(point);
    }
    for (const FlatPiece& piece : face.pieces) {
      struct {
        const FlatPiece& piece;
        std::size_t size = piece.size;
        std::array<Rational, 3> operator()(std::size_t k) const {
          const auto& [p, weight, vertex] = piece.corners[k];
          return {Rational(p[0], weight), Rational(p[1], weight), Rational(p[2], weight)};
        }
      } const corners{piece};
      const Rational area = doubled_area(normal, corners);
      EXPECT_GT(area, 0);
      left -= area;
    }
    EXPECT_EQ(left, 0);
    for (const IntegerVector& point : points) {
      int within = 0;
      for (const FlatPiece& piece : face.pieces) {
        bool inside = true;
        for (std::size_t k = 0; k < piece.size; ++k) {
          const IntegerVector off = point - Integer(1000000007) * piece.sides[k].start.exact;
          inside = inside && dot(normal, cross(piece.sides[k].along.exact, off)) > 0;
        }
        within += inside ? 1 : 0;
      }
      EXPECT_EQ(within, 1);
    }
  }
}

TEST(FlatPieces, CoverEachFaceOnce) {
  bodies::for_each_seed(20, [&](std::mt19937& dice) {
    polycubes::Cells cells = polycubes::random_cells(dice, 60, 5);
    while (!polycubes::is_valid(polycubes::solid(cells))) {
      cells = polycubes::random_cells(dice, 60, 5);
    }
    expect_cover(polycubes::solid(cells), dice);
    expect_cover(polycubes::solid(cells, polycubes::random_matrix(dice, 5)), dice);
  });
}

}  // namespace
}  // namespace minkref::of_growth_of_sums_in_space
