// An input's text, made fit for a message.
#pragma once

#include <string>
#include <string_view>

namespace minkref {

/// Printable ASCII only: "?" replaces every other byte.
std::string printable(std::string_view text);

/// In double quotes, printable, cut after 40 characters (a message never holds a number of a
/// million digits).
std::string in_quotes(std::string_view text);

}  // namespace minkref
