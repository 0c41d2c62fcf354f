// Turns of loops, which grow with the work on any machine.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "reference/interrupt.hpp"

namespace minkref::testing {

/// How often the work looks for an interrupt, in units of 64.
template <class Work>
double turns(const Work& work) {
  std::uint64_t looks = 0;
  const Interruptible counting([&] { ++looks; });
  work();
  return static_cast<double>(looks);
}

/// Four times the input, with at most this exponent.
template <class Small, class Large>
void expect_growth(const Small& small, const Large& large, double exponent = 1.25) {
  const double before = turns(small), after = turns(large);
  EXPECT_GT(before, 20);
  EXPECT_LT(after, std::pow(4, exponent) * before) << before << " turns of 64 before";
}

}  // namespace minkref::testing
