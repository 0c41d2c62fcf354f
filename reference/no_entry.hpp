#pragma once

#include <cstdint>

namespace minkref {

// In the place of an index: there is no such entry.
inline constexpr std::uint32_t no_entry = 0xffffffffU;

}  // namespace minkref
