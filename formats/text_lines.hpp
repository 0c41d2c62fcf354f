// The non-empty lines of a text as tokens.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/input.hpp"

namespace minkref {

struct TextLine {
  std::size_t number = 0;  ///< 1-based
  std::vector<std::string_view> tokens;
};

struct LineRules {
  bool comments = true;    ///< a `#` at the start of a word begins a comment
  bool continued = false;  ///< a line that ends in a backslash goes on in the next one
};

/// Walks the lines that are not empty. White space separates tokens; tokens are views into `text`.
/// A continued line has the number of its first line; a comment does not continue.
class TextLines {
 public:
  /// `lines_before`: of the same file, before `text`.
  explicit TextLines(std::string_view text, LineRules rules = {}, std::size_t lines_before = 0);

  /// The line at hand; none at the end of the text.
  const std::optional<TextLine>& line() const { return line_; }
  /// The line at hand. Refuses its absence ("truncated").
  const TextLine& due(const std::string& expected, const Input& input) const;
  void advance();
  void replace_tokens(std::vector<std::string_view> tokens) { line_->tokens = std::move(tokens); }
  std::size_t last_number() const { return number_; }

 private:
  std::string_view rest_;
  LineRules rules_;
  std::size_t number_;
  std::optional<TextLine> line_;
};

}  // namespace minkref
