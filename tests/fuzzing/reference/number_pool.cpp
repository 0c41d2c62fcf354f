// Numbers of GMP from lists of free blocks: rationals allocate all the time, and the address
// sanitizer's allocator would take a third of a run. Everything else stays with that allocator,
// the numbers' own headers included.
#include <gmp.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <new>

namespace minkref::fuzzing {
namespace {

/// Blocks up to 8 * `classes` bytes are kept for reuse; longer blocks are rare.
constexpr std::size_t classes = 32;

struct Free {
  Free* next;
};
std::array<Free*, classes + 1> lists{};

std::size_t class_of(std::size_t bytes) { return (bytes + 7) / 8; }

void* allocated(std::size_t bytes) {
  void* block = std::malloc(bytes);
  if (block == nullptr) std::abort();
  return block;
}

void* allocate(std::size_t bytes) {
  const std::size_t c = class_of(bytes);
  if (c > classes) return allocated(bytes);
  Free* block = lists[c];
  if (block == nullptr) return allocated(8 * c);
  lists[c] = block->next;
  return block;
}

void release(void* block, std::size_t bytes) {
  const std::size_t c = class_of(bytes);
  if (c > classes) return std::free(block);
  lists[c] = new (block) Free{lists[c]};
}

void* reallocate(void* block, std::size_t old_bytes, std::size_t bytes) {
  if (class_of(old_bytes) == class_of(bytes)) return block;
  void* moved = allocate(bytes);
  std::memcpy(moved, block, old_bytes < bytes ? old_bytes : bytes);
  release(block, old_bytes);
  return moved;
}

/// Before main, and so before the first number. One thread.
[[maybe_unused]] const bool installed = [] {
  mp_set_memory_functions(allocate, reallocate, release);
  return true;
}();

}  // namespace
}  // namespace minkref::fuzzing
