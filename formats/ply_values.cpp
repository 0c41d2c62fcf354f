#include "formats/ply_values.hpp"

#include <charconv>
#include <system_error>

#include "formats/message_text.hpp"

namespace minkref {

PlyText::PlyText(std::string_view file, const PlyHeader& header, const Input& input)
    : input_(input), lines_(file.substr(header.bytes), {.comments = false}, header.lines) {}

void PlyText::begin(const PlyElement& element, std::size_t row) {
  if (!lines_.line()) {
    input_.refuse("truncated",
                  "the text ends where " + printable(element.name.substr(0, 40)) + " " +
                      std::to_string(row + 1) + " of " + std::to_string(element.count) +
                      " is expected",
                  "complete the file, or correct the counts in its header", lines_.last_number());
  }
  next_ = 0;
}

std::string_view PlyText::token() {
  const TextLine& line = *lines_.line();
  if (next_ >= line.tokens.size()) {
    input_.refuse("syntax", "the line ends before the last value of its element",
                  "write one element a line, with all its properties", line.number);
  }
  return line.tokens[next_++];
}

PlyText::Number PlyText::number(PlyType) { return token(); }

std::int64_t PlyText::integer(PlyType) {
  const std::string_view text = token();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    input_.refuse("syntax", in_quotes(text) + " stands where an integer is expected",
                  "write a whole number", position());
  }
  return value;
}

void PlyText::skip(PlyType, std::uint64_t count) {
  for (; count > 0; --count) token();
}

void PlyText::end() {
  if (next_ < lines_.line()->tokens.size()) {
    input_.refuse("syntax", "the line goes on after the last value of its element",
                  "write one element a line, and check the properties in the header", position());
  }
  lines_.advance();
}

void PlyText::finish() const {
  if (!lines_.line()) return;
  input_.refuse("trailing-text", "there is text after the last element",
                "correct the counts in the header, or remove the text", position());
}

PlyBytes::PlyBytes(std::string_view file, const PlyHeader& header, const Input& input)
    : bytes_(
          file, header.bytes,
          header.encoding == PlyHeader::Encoding::big_endian ? ByteOrder::big : ByteOrder::little,
          input) {}

PlyBytes::Number PlyBytes::number(PlyType type) {
  if (type == PlyType::float32) return bytes_.float32();
  if (type == PlyType::float64) return bytes_.float64();
  return static_cast<double>(integer(type));
}

std::int64_t PlyBytes::integer(PlyType type) {
  const std::uint64_t bits = bytes_.bits(size_of(type));
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(bits);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits);
    default:
      return static_cast<std::int64_t>(bits);
  }
}

}  // namespace minkref
