// UTF-8 (RFC 3629).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace minkref {

/// The length of the well-formed character at `at`; 0 if none.
std::size_t utf8_length(std::string_view text, std::size_t at);

/// Appends a Unicode scalar value.
void append_utf8(std::string& text, std::uint32_t point);

}  // namespace minkref
