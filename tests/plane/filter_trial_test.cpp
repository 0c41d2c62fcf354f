// The grid kernel's float filter is never wrong, and is tried where plain doubles often are.
#include "reference/paper/trials/filter_trial.hpp"

#include <gtest/gtest.h>

#include "tests/number/random_numbers.hpp"

namespace minkref::testing::of_filter_trial {
namespace {

TEST(FilterTrial, FilterIsNeverWrongWherePlainDoublesOftenAre) {
  MINKREF_SEEDED(random, 1200);
  const FilterTrial trial = filter_trial(random.seed(), 200'000);
  EXPECT_EQ(trial.trials, 200'000U);
  EXPECT_EQ(trial.filter_wrong, 0U);
  EXPECT_GE(trial.doubles_wrong, 1000U);
  EXPECT_GT(trial.by_filter, 10'000U);
  EXPECT_EQ(trial.by_filter + trial.handed_on, trial.trials);
  EXPECT_LE(trial.doubles_wrong, trial.handed_on);
}

TEST(FilterTrial, SameSeedGivesTheSameTrial) {
  const FilterTrial a = filter_trial(5, 10'000), b = filter_trial(5, 10'000),
                    c = filter_trial(6, 10'000);
  EXPECT_EQ(a.by_filter, b.by_filter);
  EXPECT_EQ(a.doubles_wrong, b.doubles_wrong);
  EXPECT_TRUE(a.by_filter != c.by_filter || a.doubles_wrong != c.doubles_wrong);
}

}  // namespace
}  // namespace minkref::testing::of_filter_trial
