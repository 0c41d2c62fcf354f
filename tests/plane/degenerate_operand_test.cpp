// The empty set, a point and a segment as operands.
#include <gtest/gtest.h>

#include "reference/plane/lines.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/thin_sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_degenerate_operand {
namespace {

void expect_sum_on_all_routes(const PolygonSet& expected, const PolygonSet& P, const PolygonSet& Q,
                              const Rational& scale = 1) {
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    EXPECT_EQ(canonical_json(minkowski_sum(P, Q, scale, route).region),
              canonical_json(canonicalize(expected).region))
        << "route " << static_cast<int>(route);
  }
}

TEST(DegenerateOperand, SquareAndSlantedSegmentIsAHexagon) {
  // [0,1]^2 swept along (2,1).
  const PolygonSet hexagon = region({{0, 0}, {1, 0}, {3, 1}, {3, 2}, {2, 2}, {0, 1}});
  expect_sum_on_all_routes(hexagon, box(0, 0, 1, 1), segment_set({0, 0}, {2, 1}));
  expect_sum_on_all_routes(hexagon, box(0, 0, 1, 1), segment_set({2, 1}, {0, 0}));
  expect_sum_on_all_routes(hexagon, segment_set({0, 0}, {2, 1}), box(0, 0, 1, 1));
  expect_sum_on_all_routes(hexagon, segment_set({0, 0}, {1, Rational(1, 2)}), box(0, 0, 1, 1), 2);
}

TEST(DegenerateOperand, SquareAndParallelSegmentIsARectangle) {
  expect_sum_on_all_routes(box(3, 0, 9, 1), box(0, 0, 1, 1), segment_set({3, 0}, {8, 0}));
  expect_sum_on_all_routes(box(0, -2, 1, 1), box(0, 0, 1, 1), segment_set({0, 0}, {0, -2}));
}

TEST(DegenerateOperand, SegmentClosesASlotOfItsWidthAndShortensAHole) {
  // The frame's hole [1,3]x[1,3] swept along (1,0): a point x is out iff the segment from x - (1,0)
  // to x lies in the open hole, so the hole of the sum is (2,3)x(1,3); with (2,0) nothing is left.
  const PolygonSet frame = region(rectangle(0, 0, 4, 4), {rectangle(1, 1, 3, 3)});
  expect_sum_on_all_routes(region(rectangle(0, 0, 5, 4), {rectangle(2, 1, 3, 3)}), frame,
                           segment_set({0, 0}, {1, 0}));
  expect_sum_on_all_routes(box(0, 0, 6, 4), frame, segment_set({0, 0}, {2, 0}));
}

TEST(DegenerateOperand, TwoSquaresApartStayApartOrMeetAlongASegment) {
  const PolygonSet pair = together(box(0, 0, 1, 1), box(2, 0, 3, 1));
  const PolygonSet up = segment_set({0, 0}, {0, 1}), along = segment_set({0, 0}, {1, 0});
  expect_sum_on_all_routes(together(box(0, 0, 1, 2), box(2, 0, 3, 2)), pair, up);
  expect_sum_on_all_routes(box(0, 0, 4, 1), pair, along);  // [0,2] and [2,4]: one set
  expect_sum_on_all_routes(together(box(0, 0, Rational(3, 2), 1), box(2, 0, Rational(7, 2), 1)),
                           pair, segment_set({0, 0}, {Rational(1, 2), 0}));
}

TEST(DegenerateOperand, PointOperandTranslates) {
  const PolygonSet L = region({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});
  expect_sum_on_all_routes(shifted(L, {5, -7}), L, point_set(5, -7));
  expect_sum_on_all_routes(shifted(L, {10, -14}), point_set(5, -7), L, 2);
  expect_sum_on_all_routes(shifted(stretched(L, 2), {5, -7}), L, point_set(5, -7), 2);
}

TEST(DegenerateOperand, SegmentSumIsTheUnionOfParallelogramsAndBothEnds) {
  // A region swept along a segment consists of its two end positions and each edge's sweep.
  MINKREF_SEEDED(random, 300);
  expect_law(random, 150, [](const Case& c) {
    const Point a{-1, 2}, b{3, 1};
    PolygonSet swept = together(shifted(c.P, a), shifted(c.P, b));
    for_each_ring(c.P, [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
        if (sign(cross(q - p, b - a)) == 0) continue;
        swept = together(swept, region({p + a, q + a, q + b, p + b}));
      }
    });
    return unequal(canonicalize(swept).region, minkowski_sum(c.P, segment_set(a, b), 1).region);
  });
}

void expect_refusal(const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
  EXPECT_THROW(refuse_bad_operands(P, Q, scale), BadInput);
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    EXPECT_THROW(minkowski_sum(P, Q, scale, route), BadInput);
  }
}

TEST(DegenerateOperand, TwoOperandsWithoutAreaHaveNoTightPassages) {
  const PolygonSet point = point_set(1, 1), segment = segment_set({0, 0}, {1, 1});
  EXPECT_THROW(refuse_bad_operands(point, segment, 1), BadInput);
  EXPECT_THROW(tight_passages(segment, segment, 1), BadInput);
  EXPECT_FALSE(minkowski_sum(segment, point, 1, Route::paper, "rational", Passages::find)
                   .tight_passages.has_value());
}

TEST(DegenerateOperand, TwoSegmentsGiveAParallelogramAndParallelOnesASegment) {
  const PolygonSet segment = segment_set({0, 0}, {2, 1}), up = segment_set({0, 3}, {0, 0});
  expect_sum_on_all_routes(region({{0, 0}, {2, 1}, {2, 4}, {0, 3}}), segment, up);
  EXPECT_TRUE(sum_remnants(segment, up, 1, minkowski_sum(segment, up, 1).region).empty());
  const PolygonSet longer = segment_set({5, 3}, {1, 1});
  expect_sum_on_all_routes({}, segment, longer);
  const auto flat = sum_remnants(segment, longer, 2, {});
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat[0].points, (std::vector<Point>{{1, 1}, {9, 5}}));
}

TEST(DegenerateOperand, AFlatPartInsideTheRegionIsNoRemnant) {
  // A corner and a segment along one leg: the leg's sum bounds the other leg's.
  const PolygonSet corner = together(segment_set({0, 0}, {2, 0}), segment_set({2, 0}, {2, 2}));
  const PolygonSet along = segment_set({0, 0}, {1, 0});
  expect_sum_on_all_routes(box(2, 0, 3, 2), corner, along);
  const auto flat = sum_remnants(corner, along, 1, minkowski_sum(corner, along, 1).region);
  ASSERT_EQ(flat.size(), 1U);
  EXPECT_EQ(flat[0].points, (std::vector<Point>{{0, 0}, {2, 0}}));
}

TEST(DegenerateOperand, LinesAreTheUnionOfTheirSegments) {
  MINKREF_SEEDED(random, 301);
  expect_law(random, 60, [](const Case& c) {
    const PolygonSet parts[] = {segment_set({0, 0}, {3, 1}), segment_set({3, 1}, {0, 2}),
                                segment_set({1, -1}, {1, 3}), point_set(6, 6)};
    PolygonSet lines, swept;
    for (const PolygonSet& part : parts) {
      lines = together(lines, part);
      swept = together(swept, minkowski_sum(part, c.P, 1).region);
    }
    const PolygonSet expected = canonicalize(swept).region;
    std::string faults;
    for (const Route route : {Route::paper, Route::winding, Route::definition}) {
      faults += unequal(expected, minkowski_sum(lines, c.P, 1, route).region);
    }
    return faults;
  });
}

TEST(DegenerateOperand, JoinedLinesAreMaximalSegments) {
  const PolygonSet lines =
      together(together(segment_set({2, 2}, {1, 1}), segment_set({0, 0}, {1, 1})),
               together(together(point_set(1, 1), point_set(5, 0)), segment_set({0, 2}, {2, 0})));
  EXPECT_EQ(joined_lines(lines),
            together(together(segment_set({0, 0}, {2, 2}), segment_set({0, 2}, {2, 0})),
                     point_set(5, 0)));
  EXPECT_EQ(cut_lines(lines).polygons.size(), 5U);
  EXPECT_THROW(validate(lines), BadInput);
  EXPECT_NO_THROW(validate(lines, Lines::allowed));
}

TEST(DegenerateOperand, AScaleThatIsNotPositiveIsRefused) {
  expect_refusal(box(0, 0, 1, 1), box(0, 0, 1, 1), 0);
  expect_refusal(box(0, 0, 1, 1), box(0, 0, 1, 1), -1);
  expect_refusal(box(0, 0, 1, 1), point_set(0, 0), Rational(-1, 1000));
  expect_refusal({}, box(0, 0, 1, 1), 0);
}

TEST(DegenerateOperand, AnUnknownArithmeticIsRefused) {
  const PolygonSet square = box(0, 0, 1, 1);
  for (const char* name : {"", "float", "mpfr", "mpfr:", "mpfr:0", "mpfr:-5", "mpfr:x", "Rational",
                           "mpfr:99999999999999999999", "mpfr:53 "}) {
    EXPECT_THROW(minkowski_sum(square, square, 1, Route::paper, name), BadInput) << name;
  }
}

}  // namespace
}  // namespace minkref::testing::of_degenerate_operand
