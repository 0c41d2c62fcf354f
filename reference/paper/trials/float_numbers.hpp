// Random doubles and integers at which floats go wrong.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "reference/number/rational.hpp"

namespace minkref::float_trial {

/// The same seed gives the same numbers on every machine, compiler and rounding mode: all are made
/// of bits.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : bits_(seed) {}

  std::uint64_t below(std::uint64_t bound) { return bits_() % bound; }
  bool coin() { return (bits_() & 1) != 0; }

  /// Uniform bits; short significands; subnormal numbers; the ends of the range; near 1.
  double finite() {
    const std::uint64_t kind = below(8);
    if (kind == 0) return coin() ? 0 : of(0, 1);
    const std::uint64_t exponent = kind == 1   ? below(2047)
                                   : kind == 2 ? 0
                                   : kind == 3 ? below(60)
                                   : kind == 4 ? 2046 - below(3)
                                   : kind == 5 ? 511 + below(4)
                                               : 1023 + below(60) - 30;
    const std::uint64_t significand = bits_() >> 12;
    const std::uint64_t short_one = significand >> below(52);
    return of(exponent, coin() ? significand : coin() ? short_one : short_one << below(52));
  }
  double not_zero() {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(finite());
    return std::bit_cast<double>((bits << 1) == 0 ? bits + 1 : bits);
  }
  /// A few doubles away, or the same magnitude.
  double near(double value) {
    const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(value) << 1 >> 1);
    const std::int64_t moved = bits + static_cast<std::int64_t>(below(7)) - 3;
    if (moved < 0 || moved >= std::int64_t{2047} << 52) return value;
    const std::uint64_t sign = std::bit_cast<std::uint64_t>(value) >> 63 << 63;
    return std::bit_cast<double>(static_cast<std::uint64_t>(moved) | sign);
  }

  /// Up to so many bits, at most 62.
  std::int64_t word(unsigned bits) {
    const auto magnitude = static_cast<std::int64_t>(bits_() >> (64 - bits));
    return coin() ? magnitude : -magnitude;
  }
  Integer integer(unsigned words) {
    Integer value = word(60);
    for (unsigned k = 1; k < words; ++k) value = (value << 60) + word(60);
    return value;
  }

 private:
  double of(std::uint64_t exponent, std::uint64_t significand) {
    const std::uint64_t sign = bits_() >> 63 << 63;
    return std::bit_cast<double>(sign | exponent << 52 | (significand << 12 >> 12));
  }
  std::mt19937_64 bits_;
};

}  // namespace minkref::float_trial
