// How a sentence of the paper may be read: names and values, as the command line spells them.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace minkref {

/// One choice: its name with its values, and where in the paper it is.
struct ReadingName {
  std::string_view name;
  std::vector<std::string_view> values;  ///< the first is the printed one
  std::string_view corrected;
  std::string_view section;
};

/// Throws BadInput ("unknown-reading") that lists what there is.
[[noreturn]] void refuse_reading(const std::vector<ReadingName>& known, std::string_view name,
                                 std::string_view value);

}  // namespace minkref
