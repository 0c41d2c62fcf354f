// The memory limit and an interrupt end a build between and during all stages.
#include <gtest/gtest.h>

#include <map>

#include "reference/build/build_control.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/memory.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_build_limits {
namespace {

/// Teeth with many heights, and gaps with many widths.
PolygonSet comb(int teeth) {
  Ring ring{{-40, -100}, {100 * teeth, -100}, {100 * teeth, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    const int left = 100 * k, wide = left + 50 - k * k % 41, height = 90 + 37 * (k * k % 11);
    ring.push_back({wide, 0});
    ring.push_back({wide - 4 + k % 3, height + 5});
    ring.push_back({left + 1 + k % 4, height});
    ring.push_back({left, 0});
  }
  ring.push_back({-40, 0});
  return {{{ring, {}}}};
}

/// A progress report: the stage and the finished work.
using Step = std::pair<BuildProgress::Stage, std::uint64_t>;

struct Interrupted {};

/// More than a build of the tests takes: sanitizers keep what was freed.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t margin = std::size_t{1} << 29;
#else
constexpr std::size_t margin = std::size_t{1} << 26;
#endif

class Build {
 public:
  Build(unsigned threads, int teeth) : Q_(comb(teeth)) { options_.threads = threads; }

  /// Until `at` is reported, from when on too much memory is taken, or an interrupt waits. How it
  /// ends.
  std::string end(const Step& at, bool by_memory) {
    bool reached = false;
    std::vector<char> taken;
    options_.memory_limit = by_memory ? resident_bytes() + margin : 0;
    options_.progress = [&](const BuildProgress& now) {
      if (reached) ADD_FAILURE() << "goes on to " << now.done << " of " << now.total;
      reached = Step{now.stage, now.done} == at;
      if (reached && by_memory) taken.assign(margin, 1);
    };
    const Interruptible interruptible([&] {
      if (reached && !by_memory) throw Interrupted{};
    });
    try {
      const ScaleIndex index(P_, Q_, window_, options_);
    } catch (const LimitExceeded& e) {
      return reached ? e.code() : "too early";
    } catch (const Interrupted&) {
      return "interrupted";
    }
    return "not at all";
  }

  /// The looks at interrupts before each report.
  std::map<Step, int> looks() {
    std::map<Step, int> result;
    int count = 0;
    options_.progress = [&](const BuildProgress& now) {
      result[{now.stage, now.done}] += count;
      count = 0;
    };
    const Interruptible interruptible([&] { ++count; });
    const ScaleIndex index(P_, Q_, window_, options_);
    return result;
  }

 private:
  PolygonSet P_ = region({{0, 0}, {10, 1}, {4, 9}}), Q_;
  ScaleWindow window_{Rational(1), Rational(10)};
  BuildOptions options_;
};

using Stage = BuildProgress::Stage;
constexpr Stage stages[] = {Stage::cells, Stage::pairs, Stage::patches, Stage::rings};

TEST(BuildLimits, EndABuildInEachStage) {
  for (const unsigned threads : {1U, 2U}) {
    Build build(threads, 20);
    std::vector<Step> steps;
    for (const Stage stage : stages) steps.emplace_back(stage, 0);
    for (std::uint64_t part = 1; part < 5; ++part) steps.emplace_back(Stage::rings, part);
    for (const Step& step : steps) {
      EXPECT_EQ(build.end(step, true), "memory-limit")
          << threads << " threads, stage " << static_cast<int>(step.first) << ", part "
          << step.second;
      EXPECT_EQ(build.end(step, false), "interrupted");
    }
  }
}

TEST(BuildLimits, AreLookedAtWhileAStageLasts) {
  const std::map<Step, int> looks = Build(1, 150).looks();
  for (const Stage stage : stages) {
    int all = 0;
    for (const auto& [step, count] : looks) all += step.first == stage ? count : 0;
    EXPECT_GT(all, 4) << static_cast<int>(stage);
  }
  // Each part of the last stage, besides the look at its end.
  for (std::uint64_t part = 1; part <= 5; ++part) {
    EXPECT_GT(looks.at({Stage::rings, part}), 1) << part;
  }
}

TEST(BuildLimits, ThreadsThatGoOnEndWhenTheBuildHasFailed) {
  const BuildOptions options;
  const BuildControl control(options, "the index");
  control.look_now();
  control.stop();
  EXPECT_THROW(control.look_now(), BuildControl::Stopped);
  EXPECT_THROW(
      {
        for (unsigned k = 0; k < BuildControl::turns_between_looks; ++k) control.look();
      },
      BuildControl::Stopped);
}

}  // namespace
}  // namespace minkref::testing::of_build_limits
