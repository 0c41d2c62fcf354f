// Membership decided by the library (pairs of triangles) against edges cut at edges, and both
// against where the point lies in the sum.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_membership {
namespace {

const char* name(Contact contact) {
  return contact == Contact::empty      ? "empty"
         : contact == Contact::touching ? "touching"
                                        : "overlapping";
}

bool holds(const PolygonSet& set, const Point& x) {
  if (set.is_region()) return where(set, x) != Where::outside;
  const Ring& ring = set.polygons[0].outer;
  return set.is_point() ? x == ring[0] : on_segment(x, ring[0], ring[1]);
}

std::string wrong_witness(const Case& c, const Witness& witness, const Point& x) {
  if (witness.point != x) return "another point";
  if (witness.contact == Contact::empty) {
    return witness.p || witness.q ? "p or q of an empty contact" : "";
  }
  if (!witness.p || !witness.q) return "no p or q";
  if (!holds(c.P, *witness.p)) return "p is not in P: " + text(*witness.p);
  if (!holds(c.Q, *witness.q)) return "q is not in Q: " + text(*witness.q);
  return c.scale * *witness.p + *witness.q == x ? "" : "s p + q is not x";
}

/// Points where something can go wrong: vertex sums, middles of edge sums, vertices and edges of
/// the result, and points anywhere.
std::vector<Point> trial_points(Source& random, const Case& c, const PolygonSet& sum) {
  std::vector<Point> trial;
  const auto any = [&](const PolygonSet& set) {
    const std::vector<Edge> all = edges(set);
    if (all.empty()) return set.polygons[0].outer[0];
    const Edge& e = all[random.below(all.size())];
    return e.from + Rational(random.between(0, 4), 4) * (e.to - e.from);
  };
  for (int i = 0; i < 6; ++i) {
    trial.push_back(c.scale * any(c.P) + any(c.Q));
    trial.push_back(any(sum));
    const Rational near(1, Integer(1) << random.between(0, 40));
    trial.push_back(any(sum) +
                    Point{random.between(-3, 3) * near, Rational(random.between(-3, 3), 7)});
    trial.push_back(
        {Rational(random.between(-200, 400), 13), Rational(random.between(-200, 400), 11)});
  }
  return trial;
}

std::string membership_fault(Source& random, const Case& c) {
  const PolygonSet sum = minkowski_sum(c.P, c.Q, c.scale).region;
  const Membership membership(c.P, c.Q, c.scale);
  for (const Point& x : trial_points(random, c, sum)) {
    const std::string at = " at " + text(x);
    const Contact truth = contact_at(c.P, c.Q, c.scale, x);
    const Witness witness = membership.decide(x);
    if (witness.contact != truth) {
      return std::string(name(truth)) + " was called " + name(witness.contact) + at;
    }
    if (membership.contact(x) != truth) return "another contact without p and q" + at;
    const std::string wrong = wrong_witness(c, witness, x);
    if (!wrong.empty()) return wrong + at;
    const Where place = where(sum, x);
    if ((place == Where::outside) != (truth == Contact::empty)) return "the sum is wrong" + at;
    // The sum of the interiors is open, so it lies inside the sum's interior.
    if (place == Where::boundary && truth != Contact::touching) return "boundary in ri sum" + at;
  }
  return "";
}

TEST(Membership, AgreesWithCutEdgesAndWithThePlaceInTheSum) {
  MINKREF_SEEDED(random, 700);
  Source points(random.seed() + 1);
  expect_law(random, 60, regions, [&](const Case& c) { return membership_fault(points, c); });
}

TEST(Membership, OfPointsAndSegmentsTheRelativeInteriorCounts) {
  MINKREF_SEEDED(random, 701);
  Source points(random.seed() + 1);
  expect_law(random, 60, thin_and_wide(3, 2),
             [&](const Case& c) { return membership_fault(points, c); });
}

TEST(Membership, OnePointIsDecidedLikeMany) {
  MINKREF_SEEDED(random, 702);
  expect_law(random, 30, [](const Case& c) -> std::string {
    const Membership membership(c.P, c.Q, c.scale);
    for (int x = -8; x < 20; x += 5) {
      const Point at{x, Rational(x, 3)};
      if (decide(c.P, c.Q, c.scale, at).contact != membership.decide(at).contact) return text(at);
    }
    return "";
  });
}

TEST(Membership, NothingIsInTheSumWithTheEmptySet) {
  EXPECT_EQ(decide({}, box(0, 0, 1, 1), 1, {0, 0}).contact, Contact::empty);
  EXPECT_EQ(decide(box(0, 0, 1, 1), {}, 1, {0, 0}).contact, Contact::empty);
}

TEST(Membership, OfTwoThinOperandsEachHasItsOwnPoint) {
  MINKREF_SEEDED(random, 703);
  const auto any = [&] { return Point{Rational(random.between(-2, 2), 3), random.between(-2, 2)}; };
  const auto thin = [&](const Point& a, const Point& b) {
    return a == b ? point_set(a.x, a.y) : segment_set(a, b);
  };
  for (int i = 0; i < 200; ++i) {
    const Point a = any(), b = random.coin() ? a : any(), c = any(), d = random.coin() ? c : any();
    Case it;
    it.P = thin(a, b), it.Q = thin(c, d), it.scale = Rational(random.between(1, 4), 3);
    const Point x = it.scale * (a + Rational(random.between(0, 4), 4) * (b - a)) + c +
                    Rational(random.between(0, 4), 4) * (d - c);
    const Witness witness = decide(it.P, it.Q, it.scale, x);
    EXPECT_EQ(witness.contact, Contact::touching) << i;
    EXPECT_EQ(wrong_witness(it, witness, x), "") << i;
  }
  const Rational tiny = Rational(1) / Rational(Integer(1) << 200), third(1, 3);
  const PolygonSet segment = segment_set({0, 0}, {third, 0});
  for (const PolygonSet& other : {point_set(0, 0), segment_set({-1, 0}, {0, 0})}) {
    EXPECT_EQ(decide(segment, other, 1, {third + tiny, 0}).contact, Contact::empty);
    EXPECT_EQ(decide(other, segment, 1, {third + tiny, 0}).contact, Contact::empty);
    EXPECT_EQ(decide(segment, other, 1, {third, 0}).contact, Contact::touching);
  }
  EXPECT_EQ(decide(point_set(third, 0), point_set(0, 0), 1, {third + tiny, 0}).contact,
            Contact::empty);
}

TEST(Membership, UnitSquaresOverlapWithinTwoTouchAtTwoAndAreApartBeyond) {
  const PolygonSet square = box(0, 0, 1, 1);
  const Rational tiny = Rational(1) / Rational(Integer(1) << 200);
  EXPECT_EQ(decide(square, square, 1, {2, 1}).contact, Contact::touching);
  EXPECT_EQ(decide(square, square, 1, {2, 2}).contact, Contact::touching);
  EXPECT_EQ(decide(square, square, 1, {2 - tiny, 2 - tiny}).contact, Contact::overlapping);
  EXPECT_EQ(decide(square, square, 1, {2 + tiny, 1}).contact, Contact::empty);
  EXPECT_EQ(decide(square, square, 1, {1, 1}).contact, Contact::overlapping);
}

}  // namespace
}  // namespace minkref::testing::of_membership
