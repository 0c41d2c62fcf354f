// Random numbers for the laws of this room, over the whole range of doubles and its edges.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "reference/number/rational.hpp"

namespace minkref::testing {

/// A seeded source; every failure's trace and the test's record show the seed. The variable
/// MINKREF_SEED overrides the seed.
class Source {
 public:
  explicit Source(std::uint64_t seed) : seed_(seed) {
    if (const char* text = std::getenv("MINKREF_SEED")) seed_ = std::strtoull(text, nullptr, 10);
    engine_.seed(seed_);
    ::testing::Test::RecordProperty("seed", std::to_string(seed_));
  }
  std::uint64_t seed() const { return seed_; }

  std::uint64_t bits() { return engine_(); }
  std::uint64_t below(std::uint64_t bound) { return engine_() % bound; }
  int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low + 1)));
  }
  bool coin() { return (engine_() & 1) != 0; }

  /// A significand of `width` random bits, with its top bit set, at a random exponent, random sign.
  double with_exponent(int low, int high, int width = 53) {
    const std::uint64_t top = std::uint64_t{1} << (width - 1);
    const double magnitude = std::ldexp(static_cast<double>(top | below(top)), 1 - width);
    return std::ldexp(coin() ? magnitude : -magnitude, between(low, high));
  }

  /// Any finite double: uniform bits, small integers, short significands, subnormals, and the ends
  /// of the range, so that exact, tiny, huge and cancelling operations all occur.
  double finite() {
    constexpr double greatest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    switch (below(9)) {
      case 0:
        return uniform_bits();
      case 1:
        return between(-9, 9);
      case 2:
        return with_exponent(-30, 30, between(1, 20));
      case 3:
        return with_exponent(-1074, -1000, between(1, 53));
      case 4:
        return with_exponent(990, 1023, between(1, 53));
      case 5:
        return (coin() ? 1 : -1) * (coin() ? greatest : least);
      case 6:
        return with_exponent(-560, -480);
      case 7:
        return with_exponent(480, 540);
      default:
        return with_exponent(-3, 3);
    }
  }

  double uniform_bits() {
    double value = 0;
    do value = std::bit_cast<double>(bits());
    while (!std::isfinite(value));
    return value;
  }

  Rational rational(int most_bits = 80) {
    Integer numerator = integer(between(1, most_bits)),
            denominator = integer(between(1, most_bits));
    return Rational(coin() ? numerator : Integer(-numerator)) / Rational(denominator + 1);
  }

  Integer integer(int width) {
    Integer value = 0;
    for (int i = 0; i < width; i += 32) value = (value << 32) + (bits() & 0xffffffffU);
    return value >> ((32 - width % 32) % 32);
  }

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

/// How many of so many repetitions a run takes: a third, and all where THOROUGH=1 is set.
/// MINKREF_REPEAT multiplies them.
template <class Count>
Count repetitions(Count many) {
  const char *thorough = std::getenv("THOROUGH"), *factor = std::getenv("MINKREF_REPEAT");
  const bool all = thorough != nullptr && *thorough != '\0' && *thorough != '0';
  return (all ? many : (many + 2) / 3) * static_cast<Count>(factor ? std::atoi(factor) : 1);
}

}  // namespace minkref::testing

#define MINKREF_SEEDED(source, number)       \
  ::minkref::testing::Source source(number); \
  SCOPED_TRACE("seed " + std::to_string(source.seed()))
