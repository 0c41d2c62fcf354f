// Inputs on which published libraries have failed.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"

namespace minkref::testing::of_published_faults {
namespace {

std::vector<Sum> by_all_routes(const PolygonSet& P, const PolygonSet& Q) {
  std::vector<Sum> sums;
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    sums.push_back(minkowski_sum(P, Q, 1, route));
    EXPECT_EQ(text(sums[0].region), text(sums.back().region));
  }
  return sums;
}

void expect_membership_on_a_grid(const PolygonSet& P, const PolygonSet& Q, const PolygonSet& sum,
                                 int low, int high, int parts) {
  for (int x = low * parts; x <= high * parts; ++x) {
    for (int y = low * parts; y <= high * parts; ++y) {
      const Point at{Rational(x, parts), Rational(y, parts)};
      ASSERT_EQ(contact_at(P, Q, 1, at) == Contact::empty, where(sum, at) == Where::outside)
          << text(at);
    }
  }
}

TEST(PublishedFaults, HoleIsLostByAPointTakenOutsideItsFace) {  // CGAL 5830
  // |[0,20]^2 + triangle| = 400 + 20 + 20 + 1/2; the hole's area is 19/8.
  const PolygonSet P =
      region(rectangle(0, 0, 20, 20), {{{6, 12}, {7, 16}, {11, 16}, {9, 14}, {8, 14}, {7, 12}}});
  const PolygonSet Q = region({{1, 1}, {0, 1}, {0, 0}});
  for (const Sum& sum : by_all_routes(P, Q)) {
    EXPECT_EQ(area(sum), Rational(3505, 8));  // 438.125
    EXPECT_EQ(sum.holes, 1U);
    EXPECT_EQ(sum.components, 1U);
  }
  expect_membership_on_a_grid(P, Q, minkowski_sum(P, Q, 1).region, 6, 13, 4);
}

TEST(PublishedFaults, HolesTooSmallToSurvive) {  // CGAL 5839
  const PolygonSet P = region(rectangle(0, 0, 13, 9), {rectangle(2, 1, 6, 4), rectangle(7, 2, 8, 4),
                                                       rectangle(10, 2, 11, 4)});
  for (const Sum& sum : by_all_routes(P, box(0, 0, 3, 3))) {
    EXPECT_EQ(text(sum.region), text(box(0, 0, 16, 12)));
    EXPECT_EQ(sum.holes, 0U);
  }
}

TEST(PublishedFaults, AntennasInTheConvolutionCycle) {  // CGAL 8551
  const PolygonSet P = region({{1, 2}, {0, 1}, {2, 0}, {3, 0}, {3, 3}, {0, 2}});
  const PolygonSet Q = region({{3, 3}, {2, 2}, {0, 2}, {2, 1}});
  ASSERT_NO_THROW(validate(P));
  ASSERT_NO_THROW(validate(Q));
  const std::vector<Sum> sums = by_all_routes(P, Q);
  expect_membership_on_a_grid(P, Q, sums[0].region, -1, 7, 4);
}

TEST(PublishedFaults, OnePolygonFitsInsideAHoleOfTheOther) {  // CGAL 2517
  // The frame [0,10]^2 less (3,7)^2 with the unit square: the hole is (4,7)^2.
  const PolygonSet frame = region(rectangle(0, 0, 10, 10), {rectangle(3, 3, 7, 7)});
  const PolygonSet expected = region(rectangle(0, 0, 11, 11), {rectangle(4, 4, 7, 7)});
  for (const Sum& sum : by_all_routes(frame, box(0, 0, 1, 1))) {
    EXPECT_EQ(text(sum.region), text(canonicalize(expected).region));
  }
}

TEST(PublishedFaults, RegionsAreSummedNotBoundaries) {  // Clipper2 409
  for (const Sum& sum : by_all_routes(box(0, 0, 10, 10), box(0, 0, 1, 1))) {
    EXPECT_EQ(area(sum), 121);
    EXPECT_EQ(sum.holes, 0U);
  }
}

TEST(PublishedFaults, SmallOperandIsNotRoundedAway) {  // Clipper2, two decimals
  const PolygonSet small = box(0, 0, Rational(1, 1000), Rational(1, 1000));
  for (const Sum& sum : by_all_routes(box(0, 0, 1, 1), small)) {
    EXPECT_EQ(area(sum), Rational(1001, 1000) * Rational(1001, 1000));
  }
}

TEST(PublishedFaults, OriginOutsideTheSecondOperandDoesNotMatter) {  // manifold3d, in the plane
  for (const Sum& sum : by_all_routes(box(0, 0, 3, 1), box(10, 10, 11, 11))) {
    EXPECT_EQ(text(sum.region), text(box(10, 10, 14, 12)));
  }
}

TEST(PublishedFaults, EulerCharacteristicZeroInsideTheSum) {  // winding numbers with holes
  // x - Q is [-4.9,15.1]x[-5.1,14.9], which contains P: their intersection is P, a ring with Euler
  // characteristic 0. P's hole has side 2, too small for Q.
  const PolygonSet P = region(rectangle(0, 0, 8, 8), {rectangle(3, 3, 5, 5)});
  const PolygonSet Q = box(0, 0, 20, 20);
  const Point x{Rational(151, 10), Rational(149, 10)};
  EXPECT_EQ(contact_at(P, Q, 1, x), Contact::overlapping);
  EXPECT_EQ(decide(P, Q, 1, x).contact, Contact::overlapping);
  for (const Sum& sum : by_all_routes(P, Q)) {
    EXPECT_EQ(text(sum.region), text(box(0, 0, 28, 28)));
    EXPECT_EQ(where(sum.region, x), Where::inside);
  }
}

}  // namespace
}  // namespace minkref::testing::of_published_faults
