// The trial under each floating-point environment that another library may leave behind.
#pragma once

#include "reference/paper/trials/float_filters.hpp"

namespace minkref::float_trial {

/// A guard: while it lives, the thread rounds by the mode of `way`; the last way flushes subnormal
/// numbers (on x86-64).
class Spoiled {
 public:
  static constexpr int ways = 5;
  explicit Spoiled(int way) {
    static constexpr int modes[ways] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO,
                                        FE_TONEAREST};
    std::fegetenv(&before_);
    std::fesetround(modes[way]);
#if defined(__x86_64__)
    if (way == 4) __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
#endif
  }
  ~Spoiled() { std::fesetenv(&before_); }
  Spoiled(const Spoiled&) = delete;
  Spoiled& operator=(const Spoiled&) = delete;

 private:
  std::fenv_t before_;
};

/// Runs `count` rounds for each environment. A guard sets the standard environment for functions
/// that are not doors themselves; without a guard they refuse a spoiled environment.
[[gnu::noinline]] inline Counts run(std::uint64_t seed, std::uint64_t count) {
  Counts counts;
  for (int way = 0; way < Spoiled::ways; ++way) {
    Numbers numbers(seed * Spoiled::ways + static_cast<std::uint64_t>(way));
    const Spoiled environment(way);
    const bool was_standard = FloatEnvironment::is_standard();
    for (std::uint64_t k = 0; k < count; ++k) {
      {
        const FloatEnvironment standard;
        try_bounded_doubles(numbers, counts);
        try_intervals(numbers, counts);
        try_conversions(numbers, counts);
        try_residuals(numbers, counts);
        try_grid<Grid64>(numbers, counts, "grid of one word", 8 + static_cast<unsigned>(k % 22));
        try_grid<Grid256>(numbers, counts, "grid of four words",
                          30 + static_cast<unsigned>(k % 30));
        try_vertices(numbers, counts);
      }
      try_points(numbers, counts);
      counts.add("environment is brought back", FloatEnvironment::is_standard() == was_standard);
    }
    const auto refused = [](auto&& make) {
      try {
        make();
      } catch (const UnsafeFloats&) {
        return true;
      }
      return false;
    };
    const double any = numbers.finite();
    counts.add("without a guard", refused([&] { (void)Interval(any); }) != was_standard);
    counts.add("without a guard", refused([&] { (void)Interval(any, any); }) != was_standard);
    counts.add("without a guard", refused([&] { (void)Interval(Rational(3)); }) != was_standard);
    counts.add("without a guard",
               refused([&] { (void)BoundedDouble(Integer(3)); }) != was_standard);
  }
  return counts;
}

}  // namespace minkref::float_trial
