// A row of an event list, for events of any kind.
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

/// Appends the event as a JSON object with the members of `events_as_json`, and `end`; `edges`: the
/// text of each edge.
void append_json(std::string& text, const EventRow& event, const std::vector<std::string>& edges,
                 std::string_view end);

}  // namespace minkref
