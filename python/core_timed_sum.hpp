// The result of a sum as Python has it.
#pragma once

#include <optional>
#include <vector>

#include "python/core.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::python {

struct TimedSum {
  Set region;
  std::size_t components = 0, holes = 0;
  double seconds = 0;
  Statistics statistics;
  std::optional<std::vector<TightPassage>> tight_passages;
};

}  // namespace minkref::python
