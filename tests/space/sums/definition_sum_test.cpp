// The sum by definition: compared with sums of convex bodies, and laws for all sums.
#include "reference/space/definition/definition_sum.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/space/convex/segment_sum.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_definition_sum {
namespace {

using bodies::at;
using bodies::box;
using bodies::for_each_seed;
using bodies::random_body;
using bodies::random_scaling;
using bodies::unit;
using polycubes::solid;

const Polyhedron none, origin{{at(0, 0, 0)}, {}};

Polyhedron random_solid(std::mt19937& dice) {
  return solid(polycubes::random_cells(dice, 6, 3), polycubes::random_matrix(dice, 3));
}

std::string text(const Polyhedron& P, const Polyhedron& Q, const Scaling& s = unit) {
  return canonical_json(definition_sum(P, Q, s));
}

TEST(DefinitionSum, OfConvexBodiesIsTheirConvexSum) {
  for_each_seed(60, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3), Q = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(text(P, Q, s), canonical_json(polyhedral_set(bodies::sum(P, Q, s).surface)));
  });
}

TEST(DefinitionSum, OfTwoCubes) {
  const PolyhedralSet sum = definition_sum(box(1, 1, 1), box(1, 1, 1), {2, 2, 2});
  EXPECT_EQ(sum, polyhedral_set(box(3, 3, 3)));
  EXPECT_EQ(volume(sum), 27);
}

TEST(DefinitionSum, WithASegmentIsTheSweptBody) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron P = random_body(dice, 3);
    const Scaling s = random_scaling(dice);
    const Polyhedron segment{{at(1, 0, 2), at(-1, 3, 1)}, {}};
    const PolyhedralSet expected = polyhedral_set(
        sum_with_segment(ConvexPolyhedron(P), s, segment.vertices[0], segment.vertices[1]).surface);
    EXPECT_EQ(definition_sum(P, segment, s), expected);
    EXPECT_EQ(definition_sum(segment, scaled(P, s), unit), expected);
  });
}

TEST(DefinitionSum, WithAPointIsTheOtherOperand) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron P = random_solid(dice);
    EXPECT_EQ(text(P, origin), canonical_json(polyhedral_set(P)));
    const SpacePoint by{Rational(1, 3), -7, Rational("123456789123456789123")};
    EXPECT_EQ(text({{by}, {}}, P), canonical_json(polyhedral_set(translated(P, by))));
  });
}

TEST(DefinitionSum, WithNothingIsEmpty) {
  EXPECT_TRUE(definition_sum(none, box(1, 1, 1), unit).empty());
  EXPECT_TRUE(definition_sum(origin, none, unit).empty());
}

TEST(DefinitionSum, IsCommutative) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron P = random_solid(dice), Q = random_solid(dice);
    const Scaling s = random_scaling(dice);
    EXPECT_EQ(text(P, Q, s), text(Q, scaled(P, s)));
  });
}

TEST(DefinitionSum, IsTranslatedWithTheUnscaledOperand) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Polyhedron P = random_solid(dice), Q = random_solid(dice);
    const SpacePoint by{Rational(1, 3), -7, Rational("123456789123456789123")};
    const Scaling s = random_scaling(dice);
    PolyhedralSet moved = definition_sum(P, Q, s);
    for (auto& [plane, region] : moved.faces) {
      const IntegerVector& n = plane.normal;
      plane.offset += Rational(n[0]) * by.x + Rational(n[1]) * by.y + Rational(n[2]) * by.z;
      region = translated(region, seen(by, viewing_axis(n)));
    }
    EXPECT_EQ(text(P, translated(Q, by), s), canonical_json(moved));
  });
}

TEST(DefinitionSum, RefusesWhatHasNoVolume) {
  const Polyhedron segment{{at(0, 0, 0), at(1, 0, 0)}, {}};
  const auto code = [](const Polyhedron& P, const Polyhedron& Q, const Scaling& s) {
    try {
      definition_sum(P, Q, s);
    } catch (const BadInput& refusal) {
      return refusal.code();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(code(segment, origin, unit), "degenerate-operands");
  EXPECT_EQ(code(box(1, 1, 1), origin, {1, 0, 1}), "bad-scale");
}

TEST(DefinitionSum, RefusesTooManyPairsOfPieces) {
  polycubes::Cells apart;
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 7; ++y) {
      for (int z = 0; z < 6; ++z) apart.insert({2 * x, 2 * y, 2 * z});
    }
  }
  const Polyhedron many = solid(apart);  // 294 cubes: 86,436 pairs
  EXPECT_THROW(definition_sum(many, many, unit), LimitExceeded);
}

}  // namespace
}  // namespace minkref::of_definition_sum
