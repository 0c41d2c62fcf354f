// A build's threads share its work, and one index answers several threads at once. The preset tsan
// runs these tests to find data races.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "reference/build/stage.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_in_parallel {
namespace {

BuildOptions with_threads(unsigned threads) {
  BuildOptions options;
  options.threads = threads;
  return options;
}

TEST(InParallel, EachNumberIsWorkedOnOnceByTheWorkerOfAThread) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const BuildOptions options = with_threads(threads);
    const BuildControl control(options, "the index");
    for (const std::size_t count : {0U, 1U, 16U, 17U, 1000U}) {
      std::vector<int> times(count, 0);
      std::atomic<unsigned> workers = 0;
      in_parallel(count, control, BuildProgress::Stage::pairs, [&](unsigned thread) {
        EXPECT_LT(thread, threads);
        ++workers;
        return [&times, own = std::this_thread::get_id()](std::size_t k) {
          EXPECT_EQ(std::this_thread::get_id(), own);
          ++times[k];
        };
      });
      EXPECT_EQ(times, std::vector<int>(count, 1)) << threads << " threads";
      EXPECT_LE(workers, threads);
    }
  }
}

TEST(InParallel, WhatAnyThreadThrowsEndsAllAndIsThrown) {
  for (const unsigned culprit : {0U, 3U}) {
    const BuildOptions options = with_threads(4);
    const BuildControl control(options, "the index");
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> thrown = false;
    const auto make_worker = [&](unsigned thread) {
      return [&, thread](std::size_t) {
        if (thread == culprit) {
          thrown = true;
          throw std::runtime_error("of a worker");
        }
        while (!thrown) std::this_thread::yield();
        // Long beside the time that a thread may stand still between its throw and the others' end.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++done;
      };
    };
    constexpr std::size_t count = 10'000;
    EXPECT_THROW(in_parallel(count, control, BuildProgress::Stage::pairs, make_worker),
                 std::runtime_error);
    EXPECT_LT(done, count / 2);
  }
}

/// All answers of an index, at scales within and beside its intervals.
std::vector<std::string> answers(const ScaleIndex& index) {
  std::vector<std::string> found;
  for (int k = 1; k < 60; ++k) {
    const Rational scale(k, 15);
    TrackRings tracks;
    RoundedRings rounded;
    HomogeneousRings homogeneous;
    RationalRings rational;
    index.rings(scale, tracks);
    index.rings(scale, rounded);
    index.rings(scale, homogeneous);
    index.rings(scale, rational);
    const ScaleIndex::Features features = index.features(scale);
    std::string& text = found.emplace_back(minkref::testing::text(index.sum(scale).region));
    for (const std::size_t number :
         {std::size_t{features.components}, std::size_t{features.holes}}) {
      text += " " + std::to_string(number);
    }
    text += " " + std::to_string(index.area(scale).value);
    for (const Rational& a : index.area_polynomial(index.place(scale).interval)) {
      text += " " + to_string(a);
    }
  }
  found.push_back(std::to_string(index.timeline().topology.size()));
  return found;
}

TEST(ScaleIndex, AnswersSeveralThreadsAtOnceAsItDoesOne) {
  const PolygonSet star =
                       region({{0, 0}, {4, 1}, {9, -2}, {7, 3}, {11, 8}, {5, 6}, {1, 9}, {2, 4}}),
                   framed = region(rectangle(-9, -9, 9, 9),
                                   {rectangle(-7, -6, -1, 5), rectangle(1, -3, 4, 4)});
  const ScaleIndex index(star, framed, {Rational(1, 20), Rational(5)}, with_threads(4));
  const std::vector<std::string> alone = answers(index);
  std::vector<std::vector<std::string>> together(4);
  std::vector<std::thread> threads;
  for (std::vector<std::string>& own : together) {
    threads.emplace_back([&index, &own] { own = answers(index); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<std::string>& own : together) EXPECT_EQ(own, alone);
  EXPECT_EQ(answers(ScaleIndex(star, framed, index.window())), alone) << "built by one thread";
}

}  // namespace
}  // namespace minkref::testing::of_in_parallel
