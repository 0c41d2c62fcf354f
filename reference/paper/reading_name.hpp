// How a sentence of the paper may be read: names and values, as the command line spells them.
#pragma once

#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace minkref {

/// One choice: its name with its values, and the section of the paper.
struct ReadingName {
  std::string_view name;
  std::vector<std::string_view> values;  ///< the first is the printed one
  std::string_view corrected;
  std::string_view section;
};

/// Throws BadInput ("unknown-reading") with a list of all choices.
[[noreturn]] void refuse_reading(const std::vector<ReadingName>& known, std::string_view name,
                                 std::string_view value);

/// A choice's values with their meanings.
template <class Value>
using Words = std::initializer_list<std::pair<std::string_view, Value>>;

/// Sets the field to the meaning of `value`; throws as refuse_reading does if the value has none.
template <class Value>
void choose_reading(const std::vector<ReadingName>& known, std::string_view name,
                    std::string_view value, Value& field, Words<Value> words) {
  for (const auto& [word, meaning] : words) {
    if (value != word) continue;
    field = meaning;
    return;
  }
  refuse_reading(known, name, value);
}

}  // namespace minkref
