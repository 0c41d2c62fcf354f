// The non-empty lines of a `.poly` text as tokens.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "formats/input.hpp"
#include "formats/text_lines.hpp"

namespace minkref {

/// Walks the lines that are not empty; `#` begins a comment. A token with two decimal points, like
/// "7.84688.042924", holds two numbers run together: the walk splits it before its second point,
/// with a warning that names the line.
class PolyLines {
 public:
  PolyLines(std::string_view text, Input& input);

  /// The line at hand; none at the end of the text.
  const std::optional<TextLine>& line() const { return lines_.line(); }
  /// The line at hand. Refuses its absence ("truncated").
  const TextLine& due(const std::string& expected) const { return lines_.due(expected, input_); }
  void advance();
  std::size_t last_number() const { return lines_.last_number(); }

 private:
  void split_tokens();

  TextLines lines_;
  Input& input_;
};

}  // namespace minkref
