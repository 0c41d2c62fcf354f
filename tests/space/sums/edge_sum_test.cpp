// The sum built from edges: against the sum by definition, cells, convex sums, and what holds of
// every sum.
#include "reference/space/edges/edge_sum.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/space/definition/definition_sum.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_edge_sum {
namespace {

using bodies::at;
using bodies::box;
using bodies::for_each_seed;
using bodies::random_body;
using bodies::random_scaling;
using bodies::unit;
using polycubes::block;
using polycubes::Cells;
using polycubes::identity;
using polycubes::is_valid;
using polycubes::Matrix;
using polycubes::solid;
using polycubes::with;
using polycubes::without;

/// Also with all flat faces in pieces, which change nothing.
std::string text(const Polyhedron& P, const Polyhedron& Q, const Scaling& s = unit) {
  const PolyhedralSet sum = edge_sum(P, Q, s).set;
  EXPECT_TRUE(edge_sum(P, Q, s, {}, 0).set == sum) << "in pieces";
  return canonical_json(sum);
}

/// Random cells whose surface is a manifold.
Cells manifold_cells(std::mt19937& dice, std::size_t count, int size) {
  for (;;) {
    Cells cells = polycubes::random_cells(dice, count, size);
    if (is_valid(solid(cells))) return cells;
  }
}

void expect_sum_of_cells(const Cells& a, const Cells& b, const Matrix& m = identity) {
  const Cells expected = polycubes::sum_of_cells(a, b);
  EXPECT_EQ(text(solid(a, m), solid(b, m)), canonical_json(polyhedral_set(solid(expected, m))));
}

TEST(EdgeSum, OfConvexBodiesIsTheirConvexSum) {
  for_each_seed(60, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(text(P, Q, s), canonical_json(polyhedral_set(bodies::sum(P, Q, s).surface)));
  });
}

TEST(EdgeSum, OfRandomCellsUnderAMatrix) {
  for_each_seed(60, [&](std::mt19937& dice) {
    expect_sum_of_cells(manifold_cells(dice, 9, 3), manifold_cells(dice, 6, 3),
                        polycubes::random_matrix(dice, 5));
  });
}

TEST(EdgeSum, OfRandomCellsInTheGrid) {
  for_each_seed(40, [&](std::mt19937& dice) {
    expect_sum_of_cells(manifold_cells(dice, 12, 4), manifold_cells(dice, 7, 3));
  });
}

/// These sums' interiors have winding number 0.
TEST(EdgeSum, OfACupAndAPlate) {
  const Cells cup = without(block({0, 0, 0}, {5, 5, 5}), block({1, 1, 1}, {4, 4, 5}));
  expect_sum_of_cells(cup, block({0, 0, 0}, {7, 7, 1}));
  expect_sum_of_cells(cup, block({0, 0, 0}, {2, 2, 1}));
}

TEST(EdgeSum, KeepsACavityIffTheOtherFitsInLoosely) {
  const Cells shell = without(block({0, 0, 0}, {5, 5, 5}), block({1, 1, 1}, {4, 4, 4}));
  expect_sum_of_cells(shell, block({0, 0, 0}, {1, 2, 1}));
  expect_sum_of_cells(shell, block({0, 0, 0}, {3, 2, 1}));
  expect_sum_of_cells(shell, block({0, 0, 0}, {1, 3, 4}));
}

TEST(EdgeSum, OfFramesAndSeveralComponents) {
  const Cells frame = without(block({0, 0, 0}, {5, 5, 1}), block({1, 1, 0}, {4, 4, 1}));
  expect_sum_of_cells(frame, frame);
  const Cells two = with(block({0, 0, 0}, {1, 1, 1}), block({3, 0, 0}, {4, 2, 1}));
  expect_sum_of_cells(frame, two);
}

/// An operand's interior lies wholly within the other operand: their surfaces do not meet.
TEST(EdgeSum, HoldsWhatOneOperandHoldsWholly) {
  const Cells big = block({0, 0, 0}, {20, 20, 20});
  const Cells shell = without(block({0, 0, 0}, {5, 5, 5}), block({1, 1, 1}, {4, 4, 4}));
  const Polyhedron fine = scaled(solid(shell), {Rational(1, 10), Rational(1, 10), Rational(1, 10)});
  EXPECT_EQ(volume(edge_sum(solid(big), fine, unit).set), Rational(41 * 41 * 41, 8));
  EXPECT_EQ(volume(edge_sum(fine, solid(big), unit).set), Rational(41 * 41 * 41, 8));
}

TEST(EdgeSum, IsTheSumByDefinition) {
  for_each_seed(40, [&](std::mt19937& dice) {
    const Polyhedron P = solid(manifold_cells(dice, 5, 3), polycubes::random_matrix(dice, 4));
    const Polyhedron Q = solid(manifold_cells(dice, 4, 3), polycubes::random_matrix(dice, 4));
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(text(P, Q, s), canonical_json(definition_sum(P, Q, s)));
  });
}

/// Two prisms along the first axis, as long as each other: a slab, and over it a wedge that stands
/// on its edge at this height.
Polyhedron slab_and_wedge(int height, const Matrix& m) {
  Polyhedron result = box(4, 4, 1);
  const int top = height + 3;
  for (const auto& [y, z] : {std::pair(2, height), std::pair(3, top), std::pair(1, top)}) {
    result.vertices.push_back(at(0, y, z));
    result.vertices.push_back(at(4, y, z));
  }
  for (const Face& face :
       {Face{8, 12, 10}, {9, 11, 13}, {8, 10, 11, 9}, {10, 12, 13, 11}, {12, 8, 9, 13}}) {
    result.faces.push_back(face);
  }
  return polycubes::mapped(result, m);
}

/// Across a face of the sum, from border to border, runs an edge of another part.
TEST(EdgeSum, OfPartsThatComeToTouchAlongALine) {
  for_each_seed(10, [&](std::mt19937& dice) {
    const Matrix m = polycubes::random_matrix(dice, 4);
    const Polyhedron segment{{at(0, 0, 0), at(0, 0, 1)}, {}};
    for (const auto& [Q, height] : {std::pair(segment, 2), std::pair(bodies::octahedron(), 3)}) {
      const Polyhedron P = slab_and_wedge(height, m), other = polycubes::mapped(Q, m);
      EXPECT_EQ(text(P, other), canonical_json(definition_sum(P, other, unit)));
      EXPECT_EQ(text(other, P), text(P, other));
    }
  });
}

TEST(EdgeSum, WithAPointIsTheOtherOperand) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron P = solid(manifold_cells(dice, 6, 3), polycubes::random_matrix(dice, 3));
    const SpacePoint by{Rational(1, 3), -7, Rational("123456789123456789123")};
    EXPECT_EQ(text(P, {{by}, {}}), canonical_json(polyhedral_set(translated(P, by))));
    EXPECT_EQ(text({{by}, {}}, P), text(P, {{by}, {}}));
  });
}

TEST(EdgeSum, WithASegmentIsTheSumByDefinition) {
  for_each_seed(30, [&](std::mt19937& dice) {
    const Polyhedron P = solid(manifold_cells(dice, 6, 3), polycubes::random_matrix(dice, 3));
    std::uniform_int_distribution<int> small(-2, 2);
    const Polyhedron segment{{at(0, 0, 3), at(small(dice), small(dice), small(dice))}, {}};
    EXPECT_EQ(text(P, segment), canonical_json(definition_sum(P, segment, unit)));
    EXPECT_EQ(text(segment, P), text(P, segment));
  });
}

/// A plane polygon as the limit of a thin prism: the sum with an L-shaped one, of cells.
TEST(EdgeSum, WithAPlanePolygon) {
  const Polyhedron L{{at(0, 0, 0), at(3, 0, 0), at(3, 1, 0), at(1, 1, 0), at(1, 3, 0), at(0, 3, 0)},
                     {{0, 1, 2, 3, 4, 5}}};
  const Cells prism = with(block({0, 0, 0}, {3, 1, 1}), block({0, 1, 0}, {1, 3, 1}));
  const Cells two = with(block({0, 0, 0}, {1, 1, 1}), block({3, 0, 0}, {4, 2, 1}));
  Polyhedron flat = solid(polycubes::sum_of_cells(prism, two));
  for (SpacePoint& v : flat.vertices) v.z /= 2;  // two cells high, and one without the thickness
  EXPECT_EQ(text(solid(two), L), canonical_json(polyhedral_set(flat)));
  EXPECT_EQ(text(L, solid(two)), text(solid(two), L));
}

TEST(EdgeSum, IsTheSameOnTwoThreads) {
  for_each_seed(10, [&](std::mt19937& dice) {
    const Polyhedron P = solid(manifold_cells(dice, 12, 4), polycubes::random_matrix(dice, 3));
    BuildOptions two;
    two.threads = 2;
    EXPECT_EQ(edge_sum(P, P, unit, two).set, edge_sum(P, P, unit).set);
  });
}

/// A prism over a comb: its caps are cut into triangles as long as the comb.
Polyhedron comb_prism(int teeth) {
  std::vector<std::pair<int, int>> ring{{0, 0}, {2 * teeth, 0}};
  for (int k = teeth; k > 0; --k) {
    ring.emplace_back(2 * k, 10);
    ring.emplace_back(2 * k - 1, 1);
  }
  ring.emplace_back(0, 10);
  const auto n = static_cast<std::uint32_t>(ring.size());
  Polyhedron prism;
  for (const int z : {0, 1}) {
    for (const auto& [x, y] : ring) prism.vertices.push_back(at(x, y, z));
  }
  Face below, above;
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    below.push_back(n - 1 - k);
    above.push_back(n + k);
    prism.faces.push_back({k, next, n + next, n + k});
  }
  prism.faces.push_back(below);
  prism.faces.push_back(above);
  return prism;
}

TEST(EdgeSum, OfManyFacetsInOnePlane) {
  const Polyhedron cube = box(1, 1, 1);
  const Polyhedron small = comb_prism(9);
  EXPECT_EQ(text(small, cube), canonical_json(definition_sum(small, cube, unit)));
  // The boxes of half of all pairs meet: boxes alone used to separate coplanar facets.
  for (const int teeth : {40, 160}) {
    const EdgeSum sum = edge_sum(comb_prism(teeth), cube, unit);
    EXPECT_LT(sum.near_pairs, 6 * sum.facets) << teeth;
  }
}

/// Doubles overflow, or do not tell the coordinates apart.
TEST(EdgeSum, OfLongCoordinates) {
  const Rational huge(Integer("1" + std::string(400, '0')));
  const SpacePoint far{huge, huge + 1, -huge};
  for_each_seed(5, [&](std::mt19937& dice) {
    const Polyhedron P = solid(manifold_cells(dice, 6, 3), polycubes::random_matrix(dice, 3));
    const Polyhedron Q = solid(manifold_cells(dice, 4, 3));
    PolyhedralSet near = edge_sum(P, Q, unit).set;
    for (auto& [plane, region] : near.faces) {
      const IntegerVector& n = plane.normal;
      plane.offset += Rational(n[0]) * far.x + Rational(n[1]) * far.y + Rational(n[2]) * far.z;
      region = translated(region, seen(far, viewing_axis(n)));
    }
    EXPECT_EQ(canonical_json(edge_sum(P, translated(Q, far), unit).set), canonical_json(near));
    const Scaling tiny{1 / huge, 1 / huge, 1 / huge};
    EXPECT_EQ(text(scaled(P, tiny), scaled(Q, tiny)),
              canonical_json(definition_sum(scaled(P, tiny), scaled(Q, tiny), unit)));
  });
}

TEST(EdgeSum, RefusesWhatHasNoVolume) {
  const Polyhedron segment{{at(0, 0, 0), at(1, 0, 0)}, {}}, origin{{at(0, 0, 0)}, {}};
  EXPECT_THROW(edge_sum(segment, origin, unit), BadInput);
  EXPECT_THROW(edge_sum(box(1, 1, 1), origin, {1, 0, 1}), BadInput);
  EXPECT_TRUE(edge_sum({}, box(1, 1, 1), unit).set.empty());
}

}  // namespace
}  // namespace minkref::of_edge_sum
