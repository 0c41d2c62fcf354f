// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a child process, which may crash, hang, or ask for all available memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace minkref::cgal_oracle {

struct Limits {
  double seconds = 60;                           ///< on the clock
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of address space
  std::uint64_t answer_bytes = std::uint64_t{256} << 20;
};

enum class End {
  answered,  ///< left with 0
  crashed,   ///< by `signal`
  timed_out,
  out_of_memory,  ///< GMP was refused memory, or the system killed the child
  answer_too_large,
  exited,  ///< left with `exit_code`, not 0
};

struct Outcome {
  End end = End::answered;
  std::string text;  ///< what the child wrote, whole only if it answered
  int signal = 0;
  int exit_code = 0;
  double seconds = 0;            ///< on the clock, from the fork to the end
  std::uint64_t peak_bytes = 0;  ///< resident
};

/// Forks, runs `work` in the child under the limits, and reads the result from a pipe. The child
/// has no standard input, sends standard output to standard error, writes no core, and dies with
/// its parent. The caller sees only an Outcome. Throws std::system_error where the system refuses a
/// pipe or a process.
Outcome run_in_child(const Limits& limits, const std::function<std::string()>& work);

}  // namespace minkref::cgal_oracle
