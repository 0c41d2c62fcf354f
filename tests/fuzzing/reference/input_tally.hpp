// Counts of a process's valid, refused and other inputs, printed when the process ends.
#pragma once

#include <cstdint>

namespace minkref::fuzzing {

struct InputTally {
  std::uint64_t inputs = 0, valid = 0, refused = 0, too_large = 0, no_case = 0;

  void print() const;
};

/// The tally of this process.
InputTally& tally();

}  // namespace minkref::fuzzing
