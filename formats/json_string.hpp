// The contents of a JSON string.
#pragma once

#include <string>
#include <string_view>

namespace minkref {

/// The fault of the text between a JSON string's quotes ("" if none): control characters, unknown
/// escapes, lone surrogates, bytes that are not UTF-8.
struct JsonStringFault {
  std::string code, problem;
};
JsonStringFault fault_in_json_string(std::string_view raw);

/// Decodes a text without fault. UTF-8.
std::string decode_json_string(std::string_view raw);

/// The text as a JSON string with its quotes.
std::string encode_json_string(std::string_view text);

}  // namespace minkref
