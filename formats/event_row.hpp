// An event of any kind as lists show it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref {

struct EventRow {
  Rational scale;
  std::uint32_t rank = 0;  ///< of its scale in the list
  std::string_view kind, change;
  std::vector<std::uint32_t> edges;
  Point at;
  std::optional<Point> to;
};

/// Appends the event as a JSON object, as `events_as_json` has it, and `end`; `edges`: the text of
/// each edge.
void append_json(std::string& text, const EventRow& event, const std::vector<std::string>& edges,
                 std::string_view end);

}  // namespace minkref
