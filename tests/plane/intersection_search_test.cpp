// The searches that the dynamic update is timed against find everything.
#include "reference/paper/trials/intersection_search.hpp"

#include <gtest/gtest.h>

#include "reference/plane/convolution/convolution.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_intersection_search {
namespace {

struct Count {
  std::size_t meeting = 0;   ///< pairs of edges, not parallel, with a common point
  std::size_t contacts = 0;  ///< crossings and ends inside of an edge, for each pair
};

Rational turn(const Segment& s, const Point& p) {
  return (s.end.x - s.start.x) * (p.y - s.start.y) - (s.end.y - s.start.y) * (p.x - s.start.x);
}

bool inside(const Segment& s, const Point& p) {
  if (turn(s, p) != 0 || p == s.start || p == s.end) return false;
  const auto between = [](const Rational& a, const Rational& b, const Rational& x) {
    return (a <= x && x <= b) || (b <= x && x <= a);
  };
  return between(s.start.x, s.end.x, p.x) && between(s.start.y, s.end.y, p.y);
}

Count count_by_definition(const Case& c) {
  std::vector<Segment> segments;
  for (const ConvolutionEdge& edge : reduced_convolution(c.P, c.Q)) {
    segments.push_back(at_scale(edge, c.P, c.Q, c.scale));
  }
  Count count;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Segment &a = segments[i], &b = segments[j];
      const int a0 = sign(turn(b, a.start)), a1 = sign(turn(b, a.end));
      const int b0 = sign(turn(a, b.start)), b1 = sign(turn(a, b.end));
      const bool parallel = turn(a, b.end) == turn(a, b.start);
      if (!parallel && a0 * a1 <= 0 && b0 * b1 <= 0) ++count.meeting;
      if (a0 * a1 < 0 && b0 * b1 < 0) ++count.contacts;
      count.contacts += std::size_t{inside(a, b.start)} + inside(a, b.end) + inside(b, a.start) +
                        inside(b, a.end);
    }
  }
  return count;
}

TEST(IntersectionSearch, ContactsAreThoseOfTheDefinition) {
  MINKREF_SEEDED(random, 4100);
  expect_law(random, 100, [](const Case& c) -> std::string {
    const std::size_t found = ContactSearch(c.P, c.Q).run(c.scale);
    return found == count_by_definition(c).contacts ? "" : "found " + std::to_string(found);
  });
}

/// Grown until doubles hold all numbers exactly; then the yardstick is right too.
TEST(IntersectionSearch, PairwiseSearchIsRightWhereDoublesAreExact) {
  MINKREF_SEEDED(random, 4101);
  const auto whole = [](const PolygonSet& set) {
    Integer factor = 1;
    for_each_ring(set, [&](const Ring& ring) {
      for (const Point& p : ring) factor *= denominator(p.x) * denominator(p.y);
    });
    return scaled(set, Rational(factor));
  };
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    const Case drawn = random_case(random);
    const Case c{whole(drawn.P), whole(drawn.Q), random.between(1, 4)};
    bool small = true;
    for (const PolygonSet& set : {c.P, c.Q}) {
      for_each_ring(set, [&](const Ring& ring) {
        for (const Point& p : ring) small = small && abs(p.x) < 100'000 && abs(p.y) < 100'000;
      });
    }
    if (!small) continue;
    ++tried;
    PairwiseSearch search(c.P, c.Q);
    EXPECT_EQ(search.run(c.scale), count_by_definition(c).meeting) << text(c);
    EXPECT_EQ(search.run(c.scale), count_by_definition(c).meeting) << "a second time: " << text(c);
  }
  EXPECT_GT(tried, 50);
}

}  // namespace
}  // namespace minkref::testing::of_intersection_search
