// JSON text for lists of millions of pair events.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/plane/critical/pair_events.hpp"

namespace minkref {

/// The events first to last - 1 as JSON objects, each followed by `end` (",\n", say):
/// {"s": "n/d", "rank": 0, "kind": "pair", "change": "birth", "parents": [A, B],
///  "at": ["n/d", "n/d"], "to": null}
/// with A and B the texts of the two edges from `edges`. Exact, in lowest terms: the text of
/// `event_places`. Some 2 us an event if coordinates fit grid64, 15 us otherwise. `P` and `Q`: the
/// events' operands. Behar & Lien 2012, Sec. 4.2.3.
std::string events_as_json(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                           const std::vector<std::string>& edges, std::size_t first,
                           std::size_t last, std::string_view end);

/// The exact scales of the events first to last - 1 as texts, each scale once, in lowest terms, and
/// the nearest doubles.
struct ScaleTexts {
  std::vector<std::int64_t> begins{0};  ///< of each text in `text`, and the end of all
  std::string text;
  std::vector<double> nearest;      ///< to each
  std::vector<std::int32_t> which;  ///< each event's text
};

/// Some 0.5 us a scale where coordinates fit grid64, 2 us otherwise.
ScaleTexts scale_texts(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                       std::size_t first, std::size_t last);

}  // namespace minkref
