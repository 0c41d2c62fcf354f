#pragma once

#include <cstdint>

namespace minkref {

// In the place of an index: there is no such entry.
inline constexpr std::uint32_t none = 0xffffffffU;

}  // namespace minkref
