#include "reference/number/float_environment.hpp"

#include "reference/number/float_self_test.hpp"

namespace minkref {

void FloatEnvironment::set() {
  if (fault_ != nullptr) refuse();
#if defined(__x86_64__)
  before_ = __builtin_ia32_stmxcsr();  // fegetenv and fesetenv take microseconds
  __builtin_ia32_ldmxcsr((before_ & ~controls) | masked_to_nearest);
  changed_ = true;
#else
  // FE_DFL_ENV is a fresh program's environment: to nearest, no traps, no flushing.
  changed_ = std::fegetenv(&before_) == 0 && std::fesetenv(FE_DFL_ENV) == 0;
#endif
  if (is_standard()) return;
  if (changed_) restore();
  refuse();
}

void FloatEnvironment::restore() {
#if defined(__x86_64__)
  __builtin_ia32_ldmxcsr(before_);
#else
  std::fesetenv(&before_);
#endif
}

void FloatEnvironment::refuse() {
  if (fault_ != nullptr) {
    throw UnsafeFloats(std::string("minkref cannot compute exactly in this program: ") + fault_ +
                       "; compile all that includes its headers without -ffast-math and its parts");
  }
  throw UnsafeFloats(
      "this thread does not round doubles to nearest, or flushes subnormal numbers to zero, as a "
      "library linked with -ffast-math makes it; hold a minkref::FloatEnvironment while you "
      "compute with minkref::Interval");
}

bool FloatEnvironment::is_standard_as_measured() {
  volatile double smallest = std::numeric_limits<double>::denorm_min();
  volatile double normal = std::numeric_limits<double>::min(), half = 0.5;
  return std::fegetround() == FE_TONEAREST && smallest > 0 && normal * half > 0;
}

namespace float_self_test {
namespace {
[[maybe_unused]] const bool library_is_tested = test();
}  // namespace
}  // namespace float_self_test

}  // namespace minkref
