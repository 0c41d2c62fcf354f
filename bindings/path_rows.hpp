// Ranges of scales and path statistics as rows for Python.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "reference/motion/held_scales.hpp"
#include "reference/motion/valid_scales.hpp"

namespace minkref::python {

using OptionalText = std::optional<std::string>;
/// From, whether it belongs to the range, to (none: no end), whether that does.
using RangeRow = std::tuple<std::string, bool, OptionalText, bool>;

inline std::vector<RangeRow> range_rows(const std::vector<ScaleRange>& ranges) {
  std::vector<RangeRow> result;
  for (const ScaleRange& range : ranges) {
    OptionalText to;
    if (range.to) to = to_string(range.to->scale);
    result.emplace_back(to_string(range.from.scale), range.from_in(), to, range.to_in());
  }
  return result;
}

/// Whether the contact is one at the place, and the contact.
template <class BoundRow>
using HeldEndRow = std::optional<std::pair<bool, BoundRow>>;
/// Range, contacts at its begin and end, stop at its sample.
template <class BoundRow>
using HeldRangeRow = std::tuple<RangeRow, HeldEndRow<BoundRow>, HeldEndRow<BoundRow>, BoundRow>;

/// `row`: makes the row of a bound.
template <class Bound, class MakeRow>
auto held_rows(const std::vector<HeldRangeOf<Bound>>& held, const MakeRow& row) {
  using BoundRow = decltype(row(held[0].stop));
  std::vector<HeldRangeRow<BoundRow>> result;
  const auto end_row = [&](const std::optional<HeldEndOf<Bound>>& end) {
    HeldEndRow<BoundRow> made;
    if (end) made.emplace(end->at_place, row(end->contact));
    return made;
  };
  for (const HeldRangeOf<Bound>& range : held) {
    result.emplace_back(range_rows({range.scales})[0], end_row(range.begin), end_row(range.end),
                        row(range.stop));
  }
  return result;
}

/// The interpreter is locked.
inline Fields statistics_fields(const PathStatistics& statistics) {
  Fields fields;
  MINKREF_PUT(statistics, pieces_of_part, pieces_of_obstacles, triples, exact_triples,
              critical_scales);
  return fields;
}

}  // namespace minkref::python
