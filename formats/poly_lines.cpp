#include "formats/poly_lines.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "formats/message_text.hpp"

namespace minkref {
namespace {

bool has_two_points(std::string_view token) {
  return std::count(token.begin(), token.end(), '.') == 2;
}

void warn(std::string_view token, std::size_t cut, std::size_t line, Input& input) {
  if (!input.keeps_warnings()) {
    input.warn(line, "");
    return;
  }
  const std::string first = in_quotes(token.substr(0, cut)), second = in_quotes(token.substr(cut));
  input.warn(line,
             in_quotes(token) + " has two decimal points: read as " + first + " and " + second);
}

}  // namespace

PolyLines::PolyLines(std::string_view text, Input& input) : lines_(text), input_(input) {
  split_tokens();
}

void PolyLines::advance() {
  lines_.advance();
  split_tokens();
}

void PolyLines::split_tokens() {
  if (!line()) return;
  const std::vector<std::string_view>& tokens = line()->tokens;
  if (std::none_of(tokens.begin(), tokens.end(), has_two_points)) return;
  std::vector<std::string_view> split;
  for (const std::string_view token : tokens) {
    if (!has_two_points(token)) {
      split.push_back(token);
      continue;
    }
    const std::size_t cut = token.rfind('.');
    split.push_back(token.substr(0, cut));
    split.push_back(token.substr(cut));
    warn(token, cut, line()->number, input_);
  }
  lines_.replace_tokens(std::move(split));
}

}  // namespace minkref
