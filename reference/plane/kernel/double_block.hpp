// Four doubles at a time, and functions compiled once more for wider registers. The operations, and
// so the results, are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// No clones under the thread sanitizer: the code that chooses a clone runs before the sanitizer,
// and crashes.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_THREAD__)
#define MINKREF_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define MINKREF_CLONES
#endif
#define MINKREF_INLINE inline __attribute__((always_inline))

namespace minkref::inline plane {

inline constexpr std::size_t block_width = 4;
using Block = double __attribute__((vector_size(8 * block_width)));
using BlockMask = std::int64_t __attribute__((vector_size(8 * block_width)));

MINKREF_INLINE Block load_block(const double* from) {
  Block block;  // copied: a cast to a vector type of less alignment is an aligned load to clang
  std::memcpy(&block, from, sizeof block);
  return block;
}

}  // namespace minkref::inline plane
