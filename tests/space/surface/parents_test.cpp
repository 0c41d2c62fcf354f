#include "reference/space/surface/parents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "reference/space/edges/edge_sum.hpp"
#include "reference/space/surface/parent_faces.hpp"
#include "reference/space/surface/space_vertex.hpp"

namespace minkref::of_parents {
namespace {

/// A bar with an L for its cross-section: concave.
Polyhedron bar() {
  return {{{0, 0, 0},
           {3, 0, 0},
           {3, 1, 0},
           {1, 1, 0},
           {1, 3, 0},
           {0, 3, 0},
           {0, 0, 2},
           {3, 0, 2},
           {3, 1, 2},
           {1, 1, 2},
           {1, 3, 2},
           {0, 3, 2}},
          {{5, 4, 3, 2, 1, 0},
           {6, 7, 8, 9, 10, 11},
           {0, 1, 7, 6},
           {1, 2, 8, 7},
           {2, 3, 9, 8},
           {3, 4, 10, 9},
           {4, 5, 11, 10},
           {5, 0, 6, 11}}};
}
Polyhedron tetrahedron() {
  return {{{0, 0, 0}, {Rational(1, 2), 0, 0}, {0, Rational(1, 3), 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

struct Sum {
  PolyhedralSet set;
  std::vector<ConvolutionFacet> facets;
  Integer denominator;

  Sum(const Polyhedron& P, const Polyhedron& Q) : set(edge_sum(P, Q, {1, 1, 1}).set) {
    const SpaceOperands operands = space_operands(P, Q, {1, 1, 1});
    denominator = operands.denominator;
    facets = convolution_facets(operands.P, operands.Q).facets;
  }
};

TEST(Parents, CoverEachFaceOfASum) {
  const Sum sum(bar(), tetrahedron());
  const auto found = parents(sum.set, sum.facets, sum.denominator);
  ASSERT_EQ(found.size(), sum.set.faces.size());
  for (std::size_t r = 0; r < found.size(); ++r) {
    EXPECT_FALSE(found[r].empty());
    // Every unnamed facet of the plane has to lie beside the region: without it, the named facets
    // still cover at least the region's area.
    Rational covered = 0;
    for (const std::uint32_t f : found[r]) {
      const ConvolutionFacet& facet = sum.facets[f];
      const OrientedPlane& plane = sum.set.faces[r].plane;
      EXPECT_EQ(primitive(facet.normal.exact), plane.normal);
      Ring ring;
      for (std::size_t k = 0; k < facet.size; ++k) {
        const IntegerVector& c = facet.corners[k].exact;
        ring.push_back(seen({Rational(c[0], sum.denominator), Rational(c[1], sum.denominator),
                             Rational(c[2], sum.denominator)},
                            viewing_axis(plane.normal)));
      }
      covered += abs(doubled_area(ring)) / 2;
    }
    EXPECT_GE(covered, area(sum.set.faces[r].region));
  }
}

TEST(ParentFaces, AreNamedByTheVerticesOfTheOperands) {
  const Polyhedron P = bar(), Q = tetrahedron();
  const SurfaceEdges surface = surface_edges(edge_sum(P, Q, {2, 1, 1}).set);
  const auto found = parent_faces(surface, P, Q, {2, 1, 1});
  ASSERT_EQ(found.size(), surface.faces.size());
  const auto is_feature = [](const Face& feature, const Polyhedron& body) {
    return feature.size() < 3 ||
           std::find(body.faces.begin(), body.faces.end(), feature) != body.faces.end();
  };
  std::array<bool, 3> kinds{};  // by how many vertices that of P has: one, two, more
  for (std::size_t f = 0; f < found.size(); ++f) {
    EXPECT_FALSE(found[f].empty());
    EXPECT_TRUE(std::is_sorted(found[f].begin(), found[f].end()));
    const FilteredPlane plane(surface.planes[surface.faces[f].plane]);
    for (const auto& [of_P, of_Q] : found[f]) {
      EXPECT_EQ(std::min<std::size_t>(of_P.size(), 3) + std::min<std::size_t>(of_Q.size(), 3), 4U);
      EXPECT_TRUE(is_feature(of_P, P) && is_feature(of_Q, Q));
      kinds[std::min<std::size_t>(of_P.size(), 3) - 1] = true;
      for (const std::uint32_t p : of_P) {
        for (const std::uint32_t q : of_Q) {
          const SpacePoint &a = P.vertices[p], &b = Q.vertices[q];
          EXPECT_EQ(plane.side(SpaceVertex({2 * a.x + b.x, a.y + b.y, a.z + b.z})), 0);
        }
      }
    }
  }
  EXPECT_TRUE(kinds[0] && kinds[1] && kinds[2]);
}

TEST(Parents, WhatOnlyTouchesIsNoParent) {
  // A facet by hand: the triangle (0,0) (2,0) (0,2) at height 1, seen from above.
  ConvolutionFacet facet{};
  facet.kind = FacetKind::fv;
  facet.size = 3;
  facet.corners = {FilteredVector({0, 0, 1}, 0), FilteredVector({2, 0, 1}, 0),
                   FilteredVector({0, 2, 1}, 0), FilteredVector()};
  facet.normal = FilteredVector({0, 0, 4}, 0);
  const auto overlaps = [&](const PolygonSet& region, int side = 1, int height = 1) {
    const PolyhedralSet set{{{{{0, 0, side}, side * height}, region}}};
    return parents(set, {facet}, 1)[0].size() == 1;
  };
  const auto box = [](const Rational& x, const Rational& y, const Rational& size) {
    return Polygon{{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}, {}};
  };
  EXPECT_TRUE(overlaps({{box(0, 0, 1)}}));
  EXPECT_TRUE(overlaps({{box(-5, -5, 10)}}));                                      // around it
  EXPECT_TRUE(overlaps({{box(Rational(1, 4), Rational(1, 4), Rational(1, 4))}}));  // within it
  EXPECT_TRUE(overlaps({{box(Rational(9, 10), Rational(9, 10), 1)}}));
  EXPECT_FALSE(overlaps({{box(1, 1, 1)}}));   // at a corner, in the middle of its side
  EXPECT_FALSE(overlaps({{box(0, -1, 1)}}));  // along its side
  EXPECT_FALSE(overlaps({{box(2, 0, 1)}}));
  EXPECT_FALSE(overlaps({{box(0, 0, 1)}}, 1, 2));   // another plane
  EXPECT_FALSE(overlaps({{box(0, 0, 1)}}, -1, 1));  // the other way
  Polygon around = box(-1, -1, 5);
  around.holes.push_back({{0, 0}, {0, 2}, {2, 0}});
  EXPECT_FALSE(overlaps({{around}}));  // the facet fills a hole
  around.holes[0] = {{0, 0}, {0, 2}, {Rational(19, 10), 0}};
  EXPECT_TRUE(overlaps({{around}}));
}

}  // namespace
}  // namespace minkref::of_parents
