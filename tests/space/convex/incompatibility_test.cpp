// The degree of incompatibility, as printed and corrected (Behar & Lien 2012, Sec. 6).
#include "reference/space/convex/incompatibility.hpp"

#include <gtest/gtest.h>

#include "tests/space/convex/bodies.hpp"

namespace minkref::of_incompatibility {
namespace {

using bodies::at;

std::uint32_t facet_with_normal(const ConvexPolyhedron& body, int x, int y, int z) {
  for (std::uint32_t f = 0; f < body.facets(); ++f) {
    if (body.normal(f) == IntegerVector{x, y, z}) return f;
  }
  throw std::logic_error("no such facet");
}

std::uint32_t vertex_at(const ConvexPolyhedron& body, int x, int y, int z) {
  for (std::uint32_t v = 0; v < body.vertices(); ++v) {
    if (body.point(v) == IntegerVector{x, y, z}) return v;
  }
  throw std::logic_error("no such vertex");
}

/// Over a horizontal facet the apex is the compatible vertex, and the apex's edges descend by 1.
TEST(Incompatibility, PrintedIsNotZeroAtACompatibleVertex) {
  const ConvexPolyhedron P(bodies::box(1, 1, 1)), Q(bodies::octahedron());
  const std::uint32_t top = facet_with_normal(P, 0, 0, 1), apex = vertex_at(Q, 0, 0, 1);
  EXPECT_EQ(incompatibility(P, top, Q, apex, bodies::unit, Form::printed).squared_degree, 1);
  EXPECT_EQ(incompatibility(P, top, Q, apex, bodies::unit, Form::corrected).squared_degree, 0);
}

TEST(Incompatibility, IsTheSquaredDistanceOfTheWitnessFromThePlane) {
  const ConvexPolyhedron P(bodies::octahedron()), Q(bodies::box(3, 3, 3));
  const std::uint32_t facet = facet_with_normal(P, 1, 1, 1), corner = vertex_at(Q, 0, 0, 0);
  // With S = (1, 1, 2) the normal is (1, 1, 1/2); each edge rises 3 n_i over a length of 3/2.
  const Incompatibility found = incompatibility(P, facet, Q, corner, {1, 1, 2}, Form::corrected);
  EXPECT_EQ(found.squared_degree, 4);
  EXPECT_EQ(Q.point(Q.target(found.witness))[2], 0);
}

/// The corrected degree ends at a farthest vertex from everywhere; the printed one takes the
/// longest way, up or down, and runs in circles.
TEST(Incompatibility, DescentEndsWithTheCorrectedDegreeAndCirclesWithThePrinted) {
  const ConvexPolyhedron P(bodies::box(1, 1, 1));
  // A tower with a flat roof: from under the roof the longest edge goes down, and back up again.
  const ConvexPolyhedron Q(
      translated(bodies::with_apex(bodies::box(2, 2, 9), at(1, 1, 10)), at(0, 0, -9)));
  const std::uint32_t top = facet_with_normal(P, 0, 0, 1);
  for (std::uint32_t v = 0; v < Q.vertices(); ++v) {
    EXPECT_EQ(descend(P, top, Q, v, bodies::unit, Form::corrected), vertex_at(Q, 1, 1, 1));
  }
  EXPECT_EQ(descend(P, top, Q, vertex_at(Q, 0, 0, 0), bodies::unit, Form::printed), std::nullopt);
}

TEST(Incompatibility, DescentAgreesWithTheUpdate) {
  bodies::for_each_seed(40, [&](std::mt19937& dice) {
    const ConvexPolyhedron P(bodies::random_body(dice, 50)), Q(bodies::random_body(dice, 50));
    const Scaling s = bodies::random_scaling(dice);
    Contacts contacts(P, Q);
    contacts.rescale(s);
    const Compatibility found = by_traversal(contacts);
    for (std::uint32_t f = 0; f < P.facets(); ++f) {
      const auto reached = descend(P, f, Q, 0, s, Form::corrected);
      ASSERT_TRUE(reached.has_value());
      EXPECT_EQ(incompatibility(P, f, Q, found.vertex_of_Q[f], s, Form::corrected).squared_degree,
                0);
      EXPECT_EQ(incompatibility(P, f, Q, *reached, s, Form::corrected).squared_degree, 0);
    }
  });
}

}  // namespace
}  // namespace minkref::of_incompatibility
