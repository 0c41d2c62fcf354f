#include "tests/fuzzing/reference/input_tally.hpp"

#include <cstdio>
#include <cstdlib>

namespace minkref::fuzzing {

void InputTally::print() const {
  const auto n = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  std::fprintf(stderr, "pairs: inputs %llu valid %llu refused %llu too_large %llu no_case %llu\n",
               n(inputs), n(valid), n(refused), n(too_large), n(no_case));
}

InputTally& tally() {
  static InputTally counts;
  static const bool registered = std::atexit([] { tally().print(); }) == 0;
  static_cast<void>(registered);
  return counts;
}

}  // namespace minkref::fuzzing
