// How this thread computes doubles: the rounding mode, and whether subnormal numbers are flushed to
// zero.
//
// Any library of a process may have changed it: a shared library linked with -ffast-math flushes
// from when it is loaded, and a guard of another library rounds upwards. Filters and intervals are
// proved for rounding to nearest with subnormal numbers. So each door of the library holds a
// FloatEnvironment, and its caller finds the environment again as it was.
#pragma once

#include <cfenv>
#include <cstdint>

#include "reference/error.hpp"
#include "reference/number/float_flags.hpp"

namespace minkref {

/// This thread, or this program, does not compute doubles as the library needs them.
class UnsafeFloats : public Error {
 public:
  using Error::Error;
};

/// While it lives this thread rounds to nearest, keeps subnormal numbers and traps no exception;
/// its end brings back what was there before. Throws UnsafeFloats where that cannot be had: a part
/// of the program was compiled with flags that change what doubles are (float_self_test.hpp). Takes
/// some nanoseconds where nothing is to be changed.
class FloatEnvironment {
 public:
  FloatEnvironment() {
    if (!is_standard()) set();
    fence();
  }
  ~FloatEnvironment() {
    fence();
    if (changed_) restore();
  }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

  /// Whether this thread computes so now, and the program can.
  static bool is_standard() {
    if (fault_ != nullptr) return false;
#if defined(__x86_64__)
    return (__builtin_ia32_stmxcsr() & controls) == masked_to_nearest;
#elif defined(__aarch64__)
    constexpr std::uint64_t controls = 0x01c09f07;  // flushing, rounding, traps, other arithmetics
    std::uint64_t word = 0;
    asm volatile("mrs %0, fpcr" : "=r"(word));
    return (word & controls) == 0;
#else
    return is_standard_as_measured();
#endif
  }

  /// Throws UnsafeFloats unless it does.
  static void require() {
    if (!is_standard()) refuse();
  }

  /// The fault that a self-test has found: from then on there is no FloatEnvironment.
  static const char* fault() { return fault_; }
  static void report(const char* fault) { fault_ = fault; }

 private:
  void set();
  void restore();
  [[noreturn]] static void refuse();
  static bool is_standard_as_measured();
  /// Doubles in memory are not read, computed with and written beyond it.
  static void fence() { asm volatile("" ::: "memory"); }

  inline static const char* fault_ = nullptr;
  bool changed_ = false;
#if defined(__x86_64__)
  // Bits of the word MXCSR: flushing, rounding, masks of exceptions. Doubles are computed nowhere
  // else.
  static constexpr unsigned controls = 0xffc0, masked_to_nearest = 0x1f80;
  unsigned before_;
#else
  std::fenv_t before_;
#endif
};

}  // namespace minkref
