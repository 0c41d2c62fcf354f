#include "formats/json_string.hpp"

#include <array>
#include <cstdint>

#include "formats/utf8.hpp"

namespace minkref {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The value of the four hexadecimal digits after "\u" at `at`; -1 if missing.
std::int32_t code_unit(std::string_view raw, std::size_t at) {
  if (at + 6 > raw.size() || raw[at] != '\\' || raw[at + 1] != 'u') return -1;
  std::int32_t unit = 0;
  for (std::size_t i = at + 2; i < at + 6; ++i) {
    const int digit = hex_digit(raw[i]);
    if (digit < 0) return -1;
    unit = 16 * unit + digit;
  }
  return unit;
}

bool is_high(std::int32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low(std::int32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

constexpr std::string_view escapes = "\"\\/bfnrt";
constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";

}  // namespace

JsonStringFault fault_in_json_string(std::string_view raw) {
  for (std::size_t i = 0; i < raw.size();) {
    const auto c = static_cast<unsigned char>(raw[i]);
    if (c < 0x20) return {"syntax", "a string holds a control character or a line break"};
    if (c >= 0x80) {
      const std::size_t length = utf8_length(raw, i);
      if (length == 0) return {"not-utf8", "a string holds bytes that are not UTF-8"};
      i += length;
    } else if (c != '\\') {
      ++i;
    } else if (i + 1 < raw.size() && escapes.find(raw[i + 1]) != std::string_view::npos) {
      i += 2;
    } else {
      const std::int32_t unit = code_unit(raw, i);
      if (unit < 0) return {"syntax", "a string holds an escape that is not JSON"};
      i += 6;
      if (is_high(unit)) {
        if (!is_low(code_unit(raw, i)))
          return {"syntax", "a string holds half of a surrogate pair"};
        i += 6;
      } else if (is_low(unit)) {
        return {"syntax", "a string holds half of a surrogate pair"};
      }
    }
  }
  return {};
}

std::string decode_json_string(std::string_view raw) {
  std::string text;
  text.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size();) {
    if (raw[i] != '\\') {
      text.push_back(raw[i++]);
    } else if (raw[i + 1] != 'u') {
      text.push_back(meanings[escapes.find(raw[i + 1])]);
      i += 2;
    } else {
      auto point = static_cast<std::uint32_t>(code_unit(raw, i));
      i += 6;
      if (is_high(static_cast<std::int32_t>(point))) {
        const auto low = static_cast<std::uint32_t>(code_unit(raw, i));
        point = 0x10000 + ((point - 0xD800) << 10) + (low - 0xDC00);
        i += 6;
      }
      append_utf8(text, point);
    }
  }
  return text;
}

std::string encode_json_string(std::string_view text) {
  static constexpr std::array<char, 17> hex{"0123456789abcdef"};
  std::string raw = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      raw += {'\\', c};
    } else if (c == '\n') {
      raw += "\\n";
    } else if (byte < 0x20) {
      raw += "\\u00";
      raw += {hex[byte >> 4], hex[byte & 15]};
    } else {
      raw.push_back(c);
    }
  }
  return raw + "\"";
}

}  // namespace minkref
