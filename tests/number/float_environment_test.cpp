// Whatever another library has made of the rounding mode and of subnormal numbers, answers are
// right, and the caller finds the environment again as it was.
#include "reference/number/float_environment.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "reference/build/in_parallel.hpp"
#include "reference/paper/trials/float_environments.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::of_float_environment {
namespace {

using float_trial::Spoiled;

TEST(FloatEnvironment, EveryOperationIsRightInEachEnvironment) {
  const auto counts = float_trial::run(1, 200);
  for (const auto& [what, count] : counts.all()) {
    EXPECT_GT(count.tried, 0U) << what;
    EXPECT_EQ(count.wrong, 0U) << what << ", seed 1";
  }
  EXPECT_GT(counts.all().size(), 20U);
}

/// Adds a square of side 2^(1 - bits) to itself, by intervals; "undecided" if they tell no sign.
std::string sum_by_intervals(int bits) {
  const Rational unit(Integer(1), Integer(1) << bits);
  const PolygonSet square{
      {{{{unit, unit}, {3 * unit, unit}, {3 * unit, 3 * unit}, {unit, 3 * unit}}, {}}}};
  const std::string right = canonical_json(minkowski_sum(square, square, 1).region);
  try {
    const auto found = minkowski_sum(square, square, 1, Route::paper, "interval");
    return canonical_json(found.region) == right ? "right" : "wrong";
  } catch (const UndecidedSign&) {
    return "undecided";
  }
}

TEST(FloatEnvironment, SumOfSubnormalSquaresIsThatOfTheStandardEnvironment) {
  for (int way = 0; way < Spoiled::ways; ++way) {
    const Spoiled environment(way);
    const bool before = FloatEnvironment::is_standard();
    EXPECT_EQ(sum_by_intervals(536), "right") << way;       // products are subnormal, and exact
    EXPECT_EQ(sum_by_intervals(1070), "undecided") << way;  // products are below all doubles
    EXPECT_EQ(FloatEnvironment::is_standard(), before) << way;
  }
}

TEST(FloatEnvironment, IsBroughtBackWhereACallThrows) {
  const Spoiled upward(1);
  EXPECT_THROW(minkowski_sum({}, {}, 0), BadInput);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
}

TEST(FloatEnvironment, IntervalsOutsideOfItAreRefusedInWords) {
  const Spoiled upward(1);
  try {
    const Interval x(1.0);
    FAIL() << x.lower();
  } catch (const UnsafeFloats& error) {
    EXPECT_NE(std::string(error.what()).find("hold a minkref::FloatEnvironment"),
              std::string::npos);
  }
}

TEST(FloatEnvironment, IsThatOfEachThreadToo) {
  struct Control {
    unsigned threads() const { return 4; }
    void before(unsigned, std::size_t) const {}
    void stop() const {}
  } control;
  const Spoiled upward(1);
  std::atomic<int> standard = 0;
  in_parallel(100, 1, control, [&](unsigned) {
    return [&](std::size_t) { standard += FloatEnvironment::is_standard() ? 1 : 0; };
  });
  EXPECT_EQ(standard, 100);
}

TEST(FloatEnvironment, FaultOfASelfTestClosesAllDoors) {
  FloatEnvironment::report("sums are reordered");
  EXPECT_THROW(minkowski_sum({}, {}, 1), UnsafeFloats);
  EXPECT_THROW(Interval(1.0), UnsafeFloats);
  FloatEnvironment::report(nullptr);
  EXPECT_NO_THROW(minkowski_sum({}, {}, 1));
}

}  // namespace
}  // namespace minkref::of_float_environment
