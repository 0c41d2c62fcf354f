// Control of a loop over rows of pairs by several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "reference/interrupt.hpp"
#include "reference/memory.hpp"

namespace minkref {

/// For in_parallel: hears interrupts, and throws LimitExceeded once the process has more than
/// `memory` bytes (0: no limit); `work` names the work that needs them.
struct RowControl {
  unsigned count;
  std::uint64_t memory;
  std::string work;

  unsigned threads() const { return count; }
  void before(unsigned, std::size_t) const {
    look_for_interrupt_now();
    if (memory != 0) check_memory(memory, work);
  }
  void stop() const {}
};

}  // namespace minkref
