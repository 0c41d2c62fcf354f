// How this thread computes doubles: the rounding mode, and whether subnormal numbers are flushed to
// zero.
//
// Any library of a process may have changed both: a shared library linked with -ffast-math flushes
// once loaded, and another library's guard rounds upwards. Filters and intervals are proved for
// rounding to nearest with subnormal numbers. So each door of the library holds a FloatEnvironment,
// and its caller finds the environment again as it was.
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

/// A guard of this thread: while it lives, the thread rounds to nearest, keeps subnormal numbers
/// and traps no exception; its end restores the former environment. Throws UnsafeFloats if part of
/// the program was compiled with flags that change the arithmetic of doubles (float_self_test.hpp),
/// or the environment cannot be set. Takes some nanoseconds where nothing has to change.
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

  /// Throws UnsafeFloats unless this thread's environment is standard.
  static void require() {
    if (!is_standard()) refuse();
  }

  /// The fault that a self-test has found: afterwards every FloatEnvironment is refused.
  static const char* fault() { return fault_; }
  static void report(const char* fault) { fault_ = fault; }

 private:
  void set();
  void restore();
  [[noreturn]] static void refuse();
  static bool is_standard_as_measured();
  /// Keeps the compiler from moving accesses to doubles across this point.
  static void fence() { asm volatile("" ::: "memory"); }

  inline static const char* fault_ = nullptr;
  bool changed_ = false;
#if defined(__x86_64__)
  // Bits of the word MXCSR: flushing, rounding, masks of exceptions. No other unit computes
  // doubles.
  static constexpr unsigned controls = 0xffc0, masked_to_nearest = 0x1f80;
  unsigned before_;
#else
  std::fenv_t before_;
#endif
};

}  // namespace minkref
