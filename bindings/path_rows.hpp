// Ranges of scales and path statistics as rows for Python.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
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

/// The interpreter is locked.
inline Fields statistics_fields(const PathStatistics& statistics) {
  Fields fields;
  MINKREF_PUT(statistics, pieces_of_part, pieces_of_obstacles, triples, exact_triples,
              critical_scales);
  return fields;
}

}  // namespace minkref::python
