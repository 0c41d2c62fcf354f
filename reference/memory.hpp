// Memory that the process has, and may have: long work ends before there is none left.
#pragma once

#include <cstdint>
#include <string>

namespace minkref {

/// Bytes that the process has in memory now; 0 where the system does not tell (Linux does).
std::uint64_t resident_bytes();

/// Bytes that the process may still take: what the machine has available, and what the process's
/// control groups leave it. The greatest number where the system does not tell. Some 50 us.
std::uint64_t available_bytes();

/// Throws LimitExceeded ("memory-limit") where the process has more than `limit` bytes in memory;
/// `work` says what needs them ("the build of the index"). Some 10 us.
void check_memory(std::uint64_t limit, const std::string& work);

}  // namespace minkref
