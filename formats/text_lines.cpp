#include "formats/text_lines.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref {
namespace {

bool is_space_in_line(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The line without its comment: a `#` begins a comment at the start of a word only, so `-1.#IND`
/// (no number) holds none.
std::string_view without_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && (i == 0 || is_space_in_line(line[i - 1]))) return line.substr(0, i);
  }
  return line;
}

/// Drops a backslash at the line's end, and tells whether it did.
bool drop_continuation(std::string_view& line) {
  std::string_view content = line;
  if (content.ends_with('\r')) content.remove_suffix(1);
  if (!content.ends_with('\\')) return false;
  line = content.substr(0, content.size() - 1);
  return true;
}

void append_tokens(std::string_view content, std::vector<std::string_view>& tokens) {
  for (std::size_t i = 0; i < content.size();) {
    std::size_t stop = i;
    while (stop < content.size() && !is_space_in_line(content[stop])) ++stop;
    if (stop > i) tokens.push_back(content.substr(i, stop - i));
    i = stop + 1;
  }
}

}  // namespace

TextLines::TextLines(std::string_view text, LineRules rules, std::size_t lines_before)
    : rest_(text), rules_(rules), number_(lines_before) {
  advance();
}

const TextLine& TextLines::due(const std::string& expected, const Input& input) const {
  if (!line_) {
    input.refuse("truncated", "the text ends where " + expected + " is expected",
                 "complete the file", number_);
  }
  return *line_;
}

void TextLines::advance() {
  line_.reset();
  while (!line_ && !rest_.empty()) {
    look_for_interrupt();
    TextLine line;
    line.number = number_ + 1;
    bool goes_on = true;
    while (goes_on && !rest_.empty()) {
      ++number_;
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view content = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (rules_.comments) content = without_comment(content);
      goes_on = rules_.continued && drop_continuation(content);
      append_tokens(content, line.tokens);
    }
    if (!line.tokens.empty()) line_ = std::move(line);
  }
}

}  // namespace minkref
