// Integers of 128 bits.
#pragma once

#include <cstdint>

#include "reference/number/rational.hpp"

namespace minkref {

__extension__ typedef __int128 Int128;

inline Integer to_integer(Int128 value) {
  const Integer high = static_cast<std::int64_t>(value >> 64);
  return (high << 64) + Integer(static_cast<std::uint64_t>(value));
}

}  // namespace minkref
