// The readings of "between" for the compatibility rule (Behar & Lien 2012, Sec. 3).
#include "reference/plane/convolution/between.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/plane/convolution/convolution_size.hpp"
#include "tests/plane/convolution_rule.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_between {
namespace {

constexpr Between readings[] = {Between::half_open, Between::open, Between::closed};

/// Pieces of a lattice: most of their edges share directions.
Case lattice_case(Source& random) {
  return {random_mesh_region(random, 4), random_mesh_region(random, 3), random_scale(random)};
}

std::string other_than_defined(const Case& c) {
  for (const Between between : readings) {
    for (const bool full : {false, true}) {
      const auto found = convolution(c.P, c.Q, full, between);
      if (sorted(found) != sorted(convolution_by_definition(c.P, c.Q, full, between))) {
        return "other edges";
      }
      if (convolution_size(c.P, c.Q, full, between) != found.size()) return "another size";
    }
  }
  return "";
}

TEST(Between, EachReadingHasTheEdgesOfItsDefinition) {
  MINKREF_SEEDED(random, 920);
  expect_law(random, 150, other_than_defined);
}

TEST(Between, EachReadingOfLatticePiecesHasTheEdgesOfItsDefinition) {
  MINKREF_SEEDED(random, 921);
  expect_law(random, 100, lattice_case, other_than_defined);
}

TEST(Between, HalfOpenIsTheConvolution) {
  MINKREF_SEEDED(random, 922);
  expect_law(random, 100, lattice_case, [](const Case& c) -> std::string {
    const bool same =
        convolution(c.P, c.Q, false, Between::half_open) == reduced_convolution(c.P, c.Q) &&
        convolution(c.P, c.Q, true, Between::half_open) == full_convolution(c.P, c.Q);
    return same ? "" : "another one";
  });
}

/// Whether the other operand has an edge in the direction of the row's edge.
bool is_parallel(const ConvolutionEdge& edge, const Case& c) {
  const bool s_edge = edge.kind == ConvolutionEdge::Kind::S;
  const auto own = corners(s_edge ? c.P : c.Q), others = corners(s_edge ? c.Q : c.P);
  const auto parent = std::find_if(own.begin(), own.end(),
                                   [&](const Corner& corner) { return corner.id == edge.edge; });
  return std::any_of(others.begin(), others.end(),
                     [&](const Corner& other) { return same_direction(parent->out, other.out); });
}

TEST(Between, ReadingsContainEachOtherAndDifferInParallelEdgesOnly) {
  MINKREF_SEEDED(random, 923);
  expect_law(random, 60, lattice_case, [](const Case& c) -> std::string {
    for (const bool full : {false, true}) {
      const auto open = sorted(convolution(c.P, c.Q, full, Between::open));
      const auto half = sorted(convolution(c.P, c.Q, full, Between::half_open));
      const auto closed = sorted(convolution(c.P, c.Q, full, Between::closed));
      const auto contains = [](const auto& large, const auto& small) {
        return std::includes(large.begin(), large.end(), small.begin(), small.end(), less_edge);
      };
      if (!contains(half, open)) return "open is no part";
      if (!contains(closed, half)) return "closed is no whole";
      std::vector<ConvolutionEdge> more;
      std::set_difference(closed.begin(), closed.end(), open.begin(), open.end(),
                          std::back_inserter(more), less_edge);
      for (const ConvolutionEdge& edge : more) {
        if (!is_parallel(edge, c)) return "another edge differs";
      }
    }
    return "";
  });
}

TEST(Between, OfTwoSquaresOpenHasNothingAndClosedAllTwice) {
  const PolygonSet square = box(0, 0, 1, 1);
  EXPECT_EQ(convolution(square, square, false, Between::open).size(), 0U);
  EXPECT_EQ(convolution(square, square, false, Between::half_open).size(), 8U);
  EXPECT_EQ(convolution(square, square, false, Between::closed).size(), 16U);
}

TEST(Between, APointMeetsEveryEdgeByEachReading) {
  const PolygonSet square = box(0, 0, 1, 1);
  const PolygonSet point{{{{{Rational(3), Rational(4)}}, {}}}};
  ASSERT_TRUE(point.is_point());
  for (const Between between : readings) {
    EXPECT_EQ(convolution(square, point, false, between).size(), 4U);
    EXPECT_EQ(convolution(point, square, false, between).size(), 4U);
  }
}

}  // namespace
}  // namespace minkref::testing::of_between
