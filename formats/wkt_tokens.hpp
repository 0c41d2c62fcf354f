// The words, numbers and marks of well-known text, with their lines.
#pragma once

#include <string>
#include <string_view>

#include "formats/input.hpp"

namespace minkref {

/// A cursor over the tokens. Refuses a missing token: "truncated" at the end of the text, "syntax"
/// elsewhere.
class WktTokens {
 public:
  WktTokens(std::string_view text, const Input& input) : text_(text), input_(input) {
    skip_space();
  }

  bool at_end() const { return at_ >= text_.size(); }
  std::size_t line() const { return line_; }  ///< of the next token

  std::string word(const std::string& expected);  ///< letters, in capitals
  bool peek_word(std::string_view capitals) const;
  bool take_word(std::string_view capitals);
  bool at_number() const;
  std::string_view number();  ///< its text, unread
  bool take(char mark);
  void expect(char mark);

 private:
  void skip_space();
  std::size_t word_end() const;
  void advance(std::size_t end);
  [[noreturn]] void refuse(const std::string& expected) const;

  std::string_view text_;
  const Input& input_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace minkref
