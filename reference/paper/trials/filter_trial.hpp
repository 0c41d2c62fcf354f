// A trial of the grid kernel's float filter on turns that are hard to decide.
#pragma once

#include <cstdint>

namespace minkref {

struct FilterTrial {
  std::uint64_t trials = 0;
  std::uint64_t by_filter = 0;      ///< certified by the float filter
  std::uint64_t filter_wrong = 0;   ///< of `by_filter`: contradicted by exact integers (must be 0)
  std::uint64_t handed_on = 0;      ///< decided by exact integers
  std::uint64_t doubles_wrong = 0;  ///< of `handed_on`: wrong by a plain double determinant
};

/// Tries random pairs of vectors of up to 60 bits, three quarters nearly or exactly parallel; exact
/// integers check every sign. The same seed gives the same trial on every machine.
FilterTrial filter_trial(std::uint64_t seed, std::uint64_t count);

}  // namespace minkref
