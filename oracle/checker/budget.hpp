// The budget for checking a certificate.
#pragma once

#include <gmpxx.h>

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
};

}  // namespace minkref::checker
