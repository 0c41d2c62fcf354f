#include "oracle/checker/json_value.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace minkref::checker {
namespace {

constexpr int deepest = 500;

class Parser {
 public:
  Parser(std::string_view text, bool reals) : text_(text), reals_(reals) {}

  Value whole() {
    check_utf8();
    Value value = parse(0);
    skip();
    require(at_ == text_.size(), "there is something after the JSON value");
    return value;
  }

 private:
  void check_utf8() const {
    for (std::size_t i = 0; i < text_.size();) {
      const auto byte = [&](std::size_t k) {
        return i + k < text_.size() ? static_cast<unsigned char>(text_[i + k]) : 0U;
      };
      const unsigned first = byte(0);
      const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
      bool good = first < 0x80 || (first >= 0xc2 && first <= 0xf4);
      for (std::size_t k = 1; k < length; ++k) good = good && (byte(k) & 0xc0) == 0x80;
      good = good && !(first == 0xe0 && byte(1) < 0xa0) && !(first == 0xed && byte(1) > 0x9f) &&
             !(first == 0xf0 && byte(1) < 0x90) && !(first == 0xf4 && byte(1) > 0x8f);
      require(good, "this is not UTF-8, at byte " + std::to_string(i));
      i += length;
    }
  }

  void skip() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != text_.npos) ++at_;
  }
  char peek() const {
    require(at_ < text_.size(), "the JSON text ends too early");
    return text_[at_];
  }
  void expect(std::string_view word) {
    require(text_.substr(at_, word.size()) == word,
            "this is not JSON, at byte " + std::to_string(at_));
    at_ += word.size();
  }

  Value parse(int depth) {
    require(depth < deepest, "the JSON text is nested too deeply");
    skip();
    Value value;
    switch (peek()) {
      case '{':
        value.kind = Value::Kind::object;
        list('}', [&] {
          skip();
          std::string name = string();
          skip();
          expect(":");
          value.members.push_back({std::move(name), parse(depth + 1)});
        });
        check_names(value);
        return value;
      case '[':
        value.kind = Value::Kind::list;
        list(']', [&] { value.items.push_back(parse(depth + 1)); });
        return value;
      case '"':
        value.kind = Value::Kind::text;
        value.text = string();
        return value;
      case 't':
      case 'f':
        value.kind = Value::Kind::boolean;
        value.truth = peek() == 't';
        expect(value.truth ? "true" : "false");
        return value;
      case 'n':
        expect("null");
        return value;
      default:
        return number();
    }
  }

  template <class Item>
  void list(char end, Item&& item) {
    ++at_;
    skip();
    if (peek() == end) {
      ++at_;
      return;
    }
    while (true) {
      item();
      skip();
      const char next = peek();
      ++at_;
      if (next == end) return;
      require(next == ',', "this is not JSON, at byte " + std::to_string(at_ - 1));
    }
  }

  static void check_names(const Value& value) {
    std::vector<std::string> names;
    for (const auto& member : value.members) names.push_back(member.name);
    std::sort(names.begin(), names.end());
    require(std::adjacent_find(names.begin(), names.end()) == names.end(),
            "an object has a member twice");
  }

  std::string string() {
    expect("\"");
    std::string result;
    while (peek() != '"') {
      const char c = text_[at_++];
      require(static_cast<unsigned char>(c) >= 0x20, "a control character in a text");
      if (c != '\\') {
        result += c;
        continue;
      }
      const char kind = peek();
      ++at_;
      const std::string_view from = "\"\\/bfnrt", to = "\"\\/\b\f\n\r\t";
      if (const auto place = from.find(kind); place != from.npos) {
        result += to[place];
      } else {
        require(kind == 'u' && text_.size() - at_ >= 4, "a bad escape in a text");
        const std::string_view hex = text_.substr(at_, 4);
        require(hex.find_first_not_of("0123456789abcdefABCDEF") == hex.npos, "a bad escape");
        append_utf8(result, static_cast<unsigned>(std::stoul(std::string(hex), nullptr, 16)));
        at_ += 4;
      }
    }
    ++at_;
    return result;
  }

  static void append_utf8(std::string& text, unsigned code) {
    require(code < 0xd800 || code > 0xdfff, "an escape of a surrogate");
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xc0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3f));
    } else {
      text += static_cast<char>(0xe0 | code >> 12);
      text += static_cast<char>(0x80 | (code >> 6 & 0x3f));
      text += static_cast<char>(0x80 | (code & 0x3f));
    }
  }

  void digits(std::string& text) {
    const std::size_t first = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') text += text_[at_++];
    require(at_ > first, "this is not JSON, at byte " + std::to_string(at_));
  }

  Value number() {
    Value value;
    value.kind = Value::Kind::integer;
    if (peek() == '-') value.text += text_[at_++];
    const std::size_t first = at_;
    digits(value.text);
    require(at_ == first + 1 || text_[first] != '0', "a number begins with 0");
    if (at_ < text_.size() && text_[at_] == '.') {
      value.kind = Value::Kind::real;
      value.text += text_[at_++];
      digits(value.text);
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      value.kind = Value::Kind::real;
      value.text += text_[at_++];
      if (peek() == '+' || peek() == '-') value.text += text_[at_++];
      digits(value.text);
    }
    require(reals_ || value.kind == Value::Kind::integer, "a number with a point or an exponent");
    require(value.kind == Value::Kind::real || value.text.size() <= most_digits,
            "a number has too many digits");
    if (value.text == "-0") value.text = "0";
    return value;
  }

  std::string_view text_;
  bool reals_;
  std::size_t at_ = 0;
};

}  // namespace

Value parse_json(std::string_view text, bool reals) { return Parser(text, reals).whole(); }

std::string written_out(const Value& value) {
  std::ostringstream out;  // texts with their lengths
  out << static_cast<int>(value.kind) << value.truth << value.text.size() << '"' << value.text;
  for (const Value& item : value.items) out << ',' << written_out(item);
  std::map<std::string, std::string> sorted;
  for (const auto& [name, member] : value.members) sorted[name] = written_out(member);
  for (const auto& [name, member] : sorted) out << ';' << name.size() << '"' << name << member;
  out << '.';
  return out.str();
}

}  // namespace minkref::checker
