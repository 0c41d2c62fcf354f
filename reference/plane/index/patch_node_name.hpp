// The name of a node along a patch.
#pragma once

#include <cstdint>

namespace minkref::inline plane {

/// An end of the edge itself, or another edge's action there.
struct NodeName {
  enum class Kind : std::uint8_t { own_start, own_end, crossing, start_of_other, end_of_other };
  Kind kind = Kind::own_start;
  std::uint32_t other = 0;
  friend bool operator==(const NodeName&, const NodeName&) = default;
};

}  // namespace minkref::inline plane
