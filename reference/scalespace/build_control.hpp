// Progress and the memory limit of a build, as its loops see them.
#pragma once

#include <string>

#include "reference/scalespace/build_options.hpp"

namespace minkref {

class BuildControl {
 public:
  explicit BuildControl(const BuildOptions& options) : options_(options) {}

  unsigned threads() const { return options_.threads == 0 ? 1 : options_.threads; }

  /// From any thread, now and then. Throws LimitExceeded ("memory-limit").
  void check_memory() const;
  /// From the calling thread.
  void report(BuildProgress::Stage stage, std::uint64_t done, std::uint64_t total) const;

 private:
  const BuildOptions& options_;
};

/// What the process has in memory now; 0 where the system does not tell.
std::uint64_t resident_bytes();

}  // namespace minkref
