// One end-to-end test for all scalar types: what each arithmetic answers.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_arithmetic {
namespace {

std::string digest(const Case& c, const std::string& arithmetic) {
  return canonical_json(minkowski_sum(c.P, c.Q, c.scale, Route::paper, arithmetic).region);
}

const char* const rounding[] = {"double", "mpfr:24", "mpfr:53", "mpfr:256"};

/// The smallest input with a hole, a component and slanted edges; all crossings at integers.
Case end_to_end() {
  return {together(region(rectangle(0, 0, 12, 12), {{{4, 4}, {8, 4}, {8, 8}, {4, 8}}}),
                   region({{20, 0}, {24, 4}, {20, 8}, {16, 4}})),
          box(0, 0, 2, 2), 1};
}

TEST(Arithmetic, EveryScalarAnswersTheEndToEndExampleExactly) {
  // The frame gives [0,14]^2 less (6,8)x(6,8); the diamond, cut off at its four tips by the square,
  // gives the octagon of its hull: (16,4)-(20,0) moved along the square's corners.
  const Case c = end_to_end();
  const PolygonSet expected =
      together(region(rectangle(0, 0, 14, 14), {rectangle(6, 6, 8, 8)}),
               region({{20, 0}, {22, 0}, {26, 4}, {26, 6}, {22, 10}, {20, 10}, {16, 6}, {16, 4}}));
  const std::string truth = canonical_json(canonicalize(expected).region);
  for (const std::string name :
       {"rational", "interval", "double", "mpfr:53", "mpfr:256", "mpfr:24"}) {
    const Sum sum = minkowski_sum(c.P, c.Q, c.scale, Route::paper, name);
    EXPECT_EQ(canonical_json(sum.region), truth) << name;
    EXPECT_EQ(sum.components, 2U) << name;
    EXPECT_EQ(sum.holes, 1U) << name;
    EXPECT_EQ(sum.statistics.kernel, name == "rational" ? "grid64" : name);
  }
}

TEST(Arithmetic, AxisParallelIntegersAreExactInEveryArithmetic) {
  MINKREF_SEEDED(random, 2000);
  const auto make = [](Source& r) {
    // Cells of a unit grid: no crossing needs a rounded division.
    const auto cells = [&](int size) {
      PolygonSet set;
      for (int i = 0; i < size; ++i) {
        const int x = r.between(0, 6), y = r.between(0, 6);
        set = together(set, box(x, y, x + r.between(1, 3), y + r.between(1, 3)));
      }
      return canonicalize(set).region;
    };
    return Case{cells(6), cells(2), r.between(1, 3)};
  };
  expect_law(random, 60, make, [](const Case& c) -> std::string {
    const std::string truth = digest(c, "rational");
    for (const char* name : rounding) {
      if (digest(c, name) != truth) return name;
    }
    return "";
  });
}

TEST(Arithmetic, IntervalIsRightOrSaysThatItDoesNotKnow) {
  MINKREF_SEEDED(random, 2001);
  int certified = 0, undecided = 0;
  expect_law(random, 150, [&](const Case& c) -> std::string {
    try {
      const std::string answer = digest(c, "interval");
      ++certified;
      return answer == digest(c, "rational") ? "" : "an interval was wrong";
    } catch (const UndecidedSign&) {
      ++undecided;
      return "";
    }
  });
  EXPECT_GT(certified, 0);
  ::testing::Test::RecordProperty("certified", certified);
  ::testing::Test::RecordProperty("undecided", undecided);
}

TEST(Arithmetic, IntervalDecidesConvexPairsInGeneralPosition) {
  MINKREF_SEEDED(random, 2002);
  int certified = 0;
  for (int i = 0; i < 30; ++i) {
    const Case c{random_convex_polygon(random, 6, 1000), random_convex_polygon(random, 6, 1000), 1};
    try {
      EXPECT_EQ(digest(c, "interval"), digest(c, "rational"));
      ++certified;
    } catch (const UndecidedSign&) {
    }
  }
  EXPECT_GT(certified, 15);
}

TEST(Arithmetic, IntervalIsUndecidedOnARoundedCoincidence) {
  // A vertex on an edge, with coordinates that are no doubles: no interval can prove the incidence.
  const PolygonSet P =
      region({{0, 0}, {Rational(1, 3), Rational(1, 7)}, {Rational(2, 3), Rational(2, 7)}, {0, 1}});
  EXPECT_THROW(minkowski_sum(P, box(0, 0, 1, 1), 1, Route::paper, "interval"), UndecidedSign);
}

TEST(Arithmetic, RoundingArithmeticsAreRightOnSomeRandomPairsAndWrongOnOthers) {
  MINKREF_SEEDED(random, 2003);
  int right = 0, wrong = 0;
  for (int i = 0; i < repetitions(60); ++i) {
    const Case c = random_case(random);
    const std::string truth = digest(c, "rational");
    for (const char* name : rounding) {
      try {
        (digest(c, name) == truth ? right : wrong) += 1;
      } catch (const Error&) {
        ++wrong;
      }
    }
  }
  EXPECT_GT(right, 0);
  EXPECT_GT(wrong, 0);
}

TEST(Arithmetic, EnoughBitsAreRightWhereNothingCoincides) {
  MINKREF_SEEDED(random, 2004);
  for (int i = 0; i < 20; ++i) {
    const Case c{random_convex_polygon(random, 6, 1000), random_convex_polygon(random, 6, 1000),
                 Rational(7, 5)};
    const Sum exact = minkowski_sum(c.P, c.Q, c.scale);
    const Sum rounded = minkowski_sum(c.P, c.Q, c.scale, Route::paper, "mpfr:256");
    EXPECT_EQ(rounded.components, exact.components);
    EXPECT_EQ(rounded.holes, exact.holes);
    EXPECT_EQ(rounded.region.vertices(), exact.region.vertices()) << text(c);
  }
}

TEST(Arithmetic, OnlyThePapersRouteTakesARoundingOne) {
  const PolygonSet square = box(0, 0, 1, 1);
  for (const Route route : {Route::winding, Route::definition}) {
    for (const char* name : rounding) {
      EXPECT_THROW(minkowski_sum(square, square, 1, route, name), BadInput) << name;
    }
  }
}

}  // namespace
}  // namespace minkref::testing::of_arithmetic
