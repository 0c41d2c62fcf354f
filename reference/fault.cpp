#include "reference/fault.hpp"

#ifdef MINKREF_FAULTS
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace minkref {
namespace {

constexpr auto names = std::to_array<std::string_view>({
#define MINKREF_FAULT_NAME(name, what) #name,
    MINKREF_FAULTS_IN_REFERENCE(MINKREF_FAULT_NAME)
#undef MINKREF_FAULT_NAME
});

/// The index of the requested fault; the fault count for none.
std::size_t asked_for() {
  const char* text = std::getenv("MINKREF_FAULT");
  if (text == nullptr || *text == '\0') return names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return i;
  }
  std::fprintf(stderr, "MINKREF_FAULT=%s: there is no such fault\n", text);
  std::exit(2);
}

}  // namespace

bool planted(Fault fault) {
  static const std::size_t number = asked_for();
  return static_cast<std::size_t>(fault) == number;
}

}  // namespace minkref
#endif
