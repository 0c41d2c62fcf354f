// Choices that depend on a seed alone: the same input is mutated and checked the same way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "reference/number/rational.hpp"

namespace minkref::fuzzing {

/// SplitMix64.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// Seeded by a text (FNV-1a).
  explicit Dice(std::string_view text) : state_(14695981039346656037U) {
    for (const char c : text) {
      state_ = (state_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
  }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// 0 to n - 1, n > 0.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  /// Both ends included.
  long between(long low, long high) {
    return low + static_cast<long>(below(static_cast<std::size_t>(high - low + 1)));
  }
  /// Once in n times.
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class Items>
  auto& of(Items& items) {
    return items[below(std::size(items))];
  }

 private:
  std::uint64_t state_;
};

/// 2^exponent.
inline Rational power_of_two(long exponent) {
  const Rational power(Integer(1) << static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1 / power) : power;
}

}  // namespace minkref::fuzzing
