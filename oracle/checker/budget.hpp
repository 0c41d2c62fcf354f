// The budget for checking a certificate.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <functional>

#include "oracle/checker/json_value.hpp"

namespace minkref::checker {

struct Budget {
  std::function<bool()> in_time;
  mpz_class tests;
  /// Throws NotVerified (out of budget) once a limit is reached.
  void spend(std::size_t count) {
    tests -= count;
    demand(tests >= 0 && in_time(), "a limit is reached", Code::out_of_budget);
  }
  /// Spends tests for a common denominator of all coordinates. Throws NotVerified (out of budget)
  /// if the coordinates, made whole, would take too much room.
  void spend_unit(const mpz_class& unit, std::size_t points) {
    const std::size_t bits = mpz_sizeinbase(unit.get_mpz_t(), 2);
    spend(1 + bits / 64);
    demand(bits <= most_bits / std::max<std::size_t>(points, 1), "a denominator is too large",
           Code::out_of_budget);
  }
  static constexpr std::size_t most_bits = std::size_t{1} << 31;
};

}  // namespace minkref::checker
