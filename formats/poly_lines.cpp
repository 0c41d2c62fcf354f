#include "formats/poly_lines.hpp"

#include <algorithm>
#include <string>

#include "formats/message_text.hpp"

namespace minkref {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The line without its comment, which begins with a `#` at the start of a word: inside a word it
/// begins none (`-1.#IND` is no number).
std::string_view without_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && (i == 0 || is_space(line[i - 1]))) return line.substr(0, i);
  }
  return line;
}

void append_token(std::string_view token, PolyLine& line, Input& input) {
  const bool two_points = std::count(token.begin(), token.end(), '.') == 2;
  if (!two_points) {
    line.tokens.push_back(token);
    return;
  }
  const std::size_t cut = token.rfind('.');
  line.tokens.push_back(token.substr(0, cut));
  line.tokens.push_back(token.substr(cut));
  if (!input.keeps_warnings()) {
    input.warn(line.number, "");
    return;
  }
  const std::string first = in_quotes(token.substr(0, cut)), second = in_quotes(token.substr(cut));
  input.warn(line.number,
             in_quotes(token) + " has two decimal points: read as " + first + " and " + second);
}

}  // namespace

PolyLines::PolyLines(std::string_view text, Input& input) : rest_(text), input_(input) {
  advance();
}

void PolyLines::advance() {
  line_.reset();
  while (!line_ && !rest_.empty()) {
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view content = without_comment(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    PolyLine line;
    line.number = number_;
    for (std::size_t i = 0; i < content.size();) {
      std::size_t stop = i;
      while (stop < content.size() && !is_space(content[stop])) ++stop;
      if (stop > i) append_token(content.substr(i, stop - i), line, input_);
      i = stop + 1;
    }
    if (!line.tokens.empty()) line_ = std::move(line);
  }
}

}  // namespace minkref
