// Memory that the process has, and may have: long work ends before memory runs out.
#pragma once

#include <cstdint>
#include <string>

namespace minkref {

/// The process's bytes in memory now; 0 if the system does not tell (Linux does).
std::uint64_t resident_bytes();

/// Bytes that the process may still take: the least of the machine's available memory and the
/// remainders of the process's control groups. The greatest number if the system does not tell.
/// Some 50 us.
std::uint64_t available_bytes();

/// Throws LimitExceeded ("memory-limit") if the process has more than `limit` bytes in memory;
/// `work` names the work that needs them ("the build of the index"). Some 10 us.
void check_memory(std::uint64_t limit, const std::string& work);

}  // namespace minkref
