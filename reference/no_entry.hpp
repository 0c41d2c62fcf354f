#pragma once

#include <cstdint>

namespace minkref {

// Stands for an index, where no entry exists.
inline constexpr std::uint32_t no_entry = 0xffffffffU;

}  // namespace minkref
