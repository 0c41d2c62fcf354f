// A reader's result: the set, its warnings, and each vertex's place within the text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// The origin of a ring of the set, so that a later refusal names its place within the file, not
/// within memory: rings may have been turned, and holes sorted under their outer rings.
struct RingOrigin {
  enum class Order : std::uint8_t { as_read, reversed, reversed_after_first };
  std::size_t ring = 0;              ///< 0-based, in the order of the file
  std::vector<std::uint32_t> lines;  ///< 1-based line of each vertex, in the order of the file
  Order order = Order::as_read;      ///< how `orient` turned it

  /// A vertex's index within the file, from its index within the set.
  std::size_t index_in_file(std::size_t index) const;
};

struct Reading {
  PolygonSet set;
  std::vector<std::string> warnings;
  std::vector<RingOrigin>
      origins;  ///< one for each ring of the set: outer, holes, outer, holes, ...
};

}  // namespace minkref
