// What became of the inputs of a process, printed when it ends.
#pragma once

#include <cstdint>

namespace minkref::fuzzing {

struct InputTally {
  std::uint64_t inputs = 0, valid = 0, refused = 0, too_large = 0, no_case = 0;

  void print() const;
};

/// That of this process.
InputTally& tally();

}  // namespace minkref::fuzzing
