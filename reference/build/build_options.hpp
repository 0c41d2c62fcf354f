// How a long build goes: threads, progress, memory.
#pragma once

#include <cstdint>
#include <functional>

namespace minkref {

/// `done` of `total` pieces of work in a stage of the build: of an index, convolution edges.
struct BuildProgress {
  enum class Stage : std::uint8_t { cells, pairs, patches, rings } stage = Stage::cells;
  std::uint64_t done = 0, total = 0;
};

struct BuildOptions {
  unsigned threads = 1;
  /// Called from the calling thread, some hundred times in all. May throw, which ends the build.
  std::function<void(const BuildProgress&)> progress;
  /// Bytes that the process may have in memory while it builds; 0: no limit.
  std::uint64_t memory_limit = 0;
};

}  // namespace minkref
