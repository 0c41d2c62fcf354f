// Tests that this translation unit computes doubles as written, for flags without a macro.
#pragma once

#include "reference/number/error_free.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::float_self_test {
namespace {  // each translation unit has its own flags, and so its own test

/// The first fault, or null. The compiler knows no value: each comes from volatile memory.
[[gnu::noinline, maybe_unused]] const char* first_fault() {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  const auto read = [](double value) -> double {
    volatile double unknown = value;
    return unknown;
  };
  const double one = read(1.0), tiny = read(0x1p-300), ulp = read(0x1p-52), half = read(0x1p-53);
  if (error_free::sum_residual(one, tiny, one + tiny) != tiny || (one + tiny) - one != 0) {
    return "sums are reordered (-fassociative-math)";
  }
  if (one + half != one || one + 3 * half != one + 2 * ulp || -one - half != -one) {
    return "sums are not rounded to nearest";
  }
  if (one + read(0x1p-53 + 0x1p-78) != one + ulp) {
    return "sums are rounded twice (extended precision)";
  }
  const double a = read(1 + 0x1p-30), b = read(1 + 0x1p-31);
  if (error_free::product_residual(a, b, a * b) != 0x1p-61) {
    return "products are reordered or fused (-ffp-contract)";
  }
  const double divisor = read(49.0), third = one / read(3.0);
  if (one / divisor * divisor == one || read(49.0) / divisor != one ||
      read(98.0) / divisor != one + one || read(3.0) / 10.0 != read(0.3) ||
      !(error_free::quotient_residual(one, read(3.0), third) > 0)) {
    return "quotients become products (-freciprocal-math)";
  }
  const double infinity = read(std::numeric_limits<double>::infinity());
  if (!std::isnan(infinity - infinity) || !std::isinf(read(0x1p1000) * read(0x1p1000)) ||
      read(std::numeric_limits<double>::quiet_NaN()) == one) {
    return "infinities and NaN are ignored (-ffinite-math-only)";
  }
  const double least = read(smallest), least_normal = read(std::numeric_limits<double>::min());
  if (!(least > 0) || least + least != 2 * smallest || !(least_normal * read(0.5) > 0)) {
    return "subnormal numbers are zero";
  }
  return nullptr;
}

/// Reports a fault, if any: all doors are closed then.
[[maybe_unused]] bool test() {
  if (FloatEnvironment::fault() != nullptr) return false;
  try {
    const FloatEnvironment standard;
    FloatEnvironment::report(first_fault());
  } catch (const UnsafeFloats&) {
    FloatEnvironment::report("the rounding mode cannot be set, or subnormal numbers are zero");
  }
  return FloatEnvironment::fault() == nullptr;
}

#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ < 12)
// These compilers do not name all of their flags: test when the program starts.
[[maybe_unused]] const bool unit_is_tested = test();
#endif

}  // namespace
}  // namespace minkref::float_self_test
