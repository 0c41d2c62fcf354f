#include "formats/json_text.hpp"

#include "formats/json_string.hpp"
#include "formats/message_text.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// JSON's own grammar of numbers: no leading zero or plus, digits on both sides of the point.
bool is_json_number(std::string_view text) {
  std::size_t i = 0;
  const auto at = [&] { return i < text.size() ? text[i] : '\0'; };
  const auto digits = [&] {
    const std::size_t before = i;
    while (is_digit(at())) ++i;
    return i > before;
  };
  if (at() == '-') ++i;
  if (at() == '0') {
    ++i;
  } else if (!digits()) {
    return false;
  }
  if (at() == '.') {
    ++i;
    if (!digits()) return false;
  }
  if (at() == 'e' || at() == 'E') {
    ++i;
    if (at() == '+' || at() == '-') ++i;
    if (!digits()) return false;
  }
  return i == text.size();
}

/// Builds the nodes of one text. Open containers form an explicit stack: depth costs no recursion.
class Parser {
 public:
  Parser(std::string_view text, const Input& input) : text_(text), input_(input) {}

  std::vector<JsonNode> run() {
    do {
      value();
      while (!complete() && !next_sibling()) {
      }
    } while (!complete());
    skip_space();
    if (at_ < text_.size()) {
      input_.refuse("trailing-text", "there is text after the end of the JSON value",
                    "keep one JSON value in the file", line_);
    }
    return std::move(nodes_);
  }

 private:
  bool complete() const { return open_.empty() && !nodes_.empty() && !pending_; }
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_space() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        return;
      }
    }
  }

  [[noreturn]] void syntax(const std::string& expected) const {
    if (at_ >= text_.size()) {
      input_.refuse("truncated", "the JSON text ends where " + expected + " is expected",
                    "complete the file", line_);
    }
    input_.refuse(
        "syntax",
        "this is not JSON: " + expected + " is expected before " + in_quotes(text_.substr(at_, 12)),
        "correct the text", line_);
  }

  std::uint32_t append(JsonKind kind, std::string_view text, bool escaped = false) {
    look_for_interrupt();
    if (nodes_.size() >= input_.limits().json_values) {
      input_.exceed(
          "too-many-values",
          "there are more than " + std::to_string(input_.limits().json_values) + " JSON values",
          "simplify the input, or raise the limit on JSON values", at_line(line_));
    }
    JsonNode node;
    node.kind = kind;
    node.text = text;
    node.line = line_;
    node.escaped = escaped;
    node.end = static_cast<std::uint32_t>(nodes_.size()) + 1;
    nodes_.push_back(node);
    return node.end - 1;
  }

  /// Reads one value, or opens a container and reads on to its first value.
  void value() {
    pending_ = false;
    skip_space();
    const char c = peek();
    if (c == '{' || c == '[') {
      open(c == '{' ? JsonKind::object : JsonKind::array);
    } else if (c == '"') {
      string();
    } else if (c == '-' || is_digit(c)) {
      number();
    } else if (is_letter(c)) {
      word();
    } else {
      syntax("a value");
    }
  }

  void open(JsonKind kind) {
    if (open_.size() >= input_.limits().depth) {
      input_.exceed("too-deep",
                    "values are nested deeper than " + std::to_string(input_.limits().depth),
                    "flatten the input, or raise the limit on depth", at_line(line_));
    }
    open_.push_back(append(kind, {}));
    ++at_;
    skip_space();
    if (peek() == (kind == JsonKind::object ? '}' : ']')) return;
    begin_element();
  }

  /// Prepares for the next element: the following value of an array, or of a member, whose name is
  /// read here.
  void begin_element() {
    JsonNode& container = nodes_[open_.back()];
    ++container.size;
    if (container.kind == JsonKind::object) {
      if (peek() != '"') syntax("the name of a member");
      string();
      skip_space();
      if (peek() != ':') syntax("\":\"");
      ++at_;
    }
    pending_ = true;
  }

  /// After a value or a fresh container: closes the containers that end here. True before a further
  /// value.
  bool next_sibling() {
    if (pending_) return true;
    skip_space();
    JsonNode& container = nodes_[open_.back()];
    const bool object = container.kind == JsonKind::object;
    const char c = peek();
    if (c == (object ? '}' : ']')) {
      ++at_;
      container.end = static_cast<std::uint32_t>(nodes_.size());
      open_.pop_back();
      return false;
    }
    if (c != ',') syntax(object ? "\",\" or \"}\"" : "\",\" or \"]\"");
    ++at_;
    skip_space();
    begin_element();
    return true;
  }

  void string() {
    const std::size_t begin = at_ + 1;
    bool escaped = false;
    std::size_t end = begin;
    while (end < text_.size() && text_[end] != '"') {
      const bool backslash = text_[end] == '\\';
      escaped = escaped || backslash;
      end += backslash ? 2 : 1;
    }
    if (end >= text_.size()) {
      at_ = text_.size();
      syntax("the end of a string");
    }
    const std::string_view raw = text_.substr(begin, end - begin);
    const JsonStringFault fault = fault_in_json_string(raw);
    if (!fault.code.empty()) {
      input_.refuse(fault.code, fault.problem, "correct the string", line_);
    }
    append(JsonKind::string, raw, escaped);
    at_ = end + 1;
  }

  void number() {
    std::size_t end = at_;
    const auto belongs = [](char c) {
      return is_digit(c) || is_letter(c) || c == '+' || c == '-' || c == '.';
    };
    while (end < text_.size() && belongs(text_[end])) ++end;
    const std::string_view token = text_.substr(at_, end - at_);
    if (!is_json_number(token)) {
      input_.refuse("not-a-number", in_quotes(token) + " is not a JSON number",
                    "write a finite decimal number with a digit on each side of its point", line_);
    }
    append(JsonKind::number, token);
    at_ = end;
  }

  void word() {
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    const std::string_view token = text_.substr(at_, end - at_);
    if (token == "null") {
      append(JsonKind::null, token);
    } else if (token == "true" || token == "false") {
      append(JsonKind::boolean, token);
    } else if (token == "NaN" || token == "nan" || token == "Infinity" || token == "inf") {
      input_.refuse("not-a-number", in_quotes(token) + " is not a number",
                    "leave the value out, or replace it by a finite one", line_);
    } else {
      syntax("a value");
    }
    at_ = end;
  }

  std::string_view text_;
  const Input& input_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  bool pending_ = false;  ///< a value is due
  std::vector<std::uint32_t> open_;
  std::vector<JsonNode> nodes_;
};

}  // namespace

std::string describe(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "a boolean";
    case JsonKind::number:
      return "a number";
    case JsonKind::string:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "a value";
}

JsonText::JsonText(std::string_view text, const Input& input) : nodes_(Parser(text, input).run()) {}

const JsonNode& Json::node() const { return document_->node(index_); }

std::string Json::string() const {
  return node().escaped ? decode_json_string(node().text) : std::string(node().text);
}

Json::Iterator Json::end() const { return {*document_, node().end}; }

Json::Iterator& Json::Iterator::operator++() {
  index_ = document_->node(index_).end;
  return *this;
}

}  // namespace minkref
