#include "formats/wkt_tokens.hpp"

#include "formats/message_text.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

bool is_wkt_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_wkt_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

void WktTokens::skip_space() {
  for (; at_ < text_.size() && is_wkt_space(text_[at_]); ++at_) {
    if (text_[at_] == '\n') ++line_;
  }
}

void WktTokens::advance(std::size_t end) {
  at_ = end;
  skip_space();
}

void WktTokens::refuse(const std::string& expected) const {
  if (at_end()) {
    input_.refuse("truncated", "the text ends where " + expected + " is expected",
                  "complete the file", line_);
  }
  input_.refuse("syntax",
                "this is not well-known text: " + expected + " is expected before " +
                    in_quotes(text_.substr(at_, 12)),
                "correct the text", line_);
}

std::size_t WktTokens::word_end() const {
  std::size_t end = at_;
  while (end < text_.size() && is_wkt_letter(text_[end])) ++end;
  return end;
}

std::string WktTokens::word(const std::string& expected) {
  const std::size_t end = word_end();
  if (end == at_) refuse(expected);
  std::string capitals;
  for (const char c : text_.substr(at_, end - at_)) capitals.push_back(capital(c));
  advance(end);
  return capitals;
}

bool WktTokens::peek_word(std::string_view capitals) const {
  if (word_end() - at_ != capitals.size()) return false;
  for (std::size_t i = 0; i < capitals.size(); ++i) {
    if (capital(text_[at_ + i]) != capitals[i]) return false;
  }
  return true;
}

bool WktTokens::take_word(std::string_view capitals) {
  if (!peek_word(capitals)) return false;
  advance(at_ + capitals.size());
  return true;
}

bool WktTokens::at_number() const {
  const char c = at_end() ? ',' : text_[at_];
  return c != '(' && c != ')' && c != ',';
}

std::string_view WktTokens::number() {
  look_for_interrupt();
  if (!at_number()) refuse("a number");
  std::size_t end = at_;
  while (end < text_.size() && !is_wkt_space(text_[end]) && text_[end] != '(' &&
         text_[end] != ')' && text_[end] != ',' && text_[end] != ';') {
    ++end;
  }
  const std::string_view token = text_.substr(at_, end - at_);
  advance(end);
  return token;
}

bool WktTokens::take(char mark) {
  if (at_end() || text_[at_] != mark) return false;
  advance(at_ + 1);
  return true;
}

void WktTokens::expect(char mark) {
  if (!take(mark)) refuse(std::string("\"") + mark + "\"");
}

}  // namespace minkref
