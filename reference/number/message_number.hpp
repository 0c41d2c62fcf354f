// Numbers for messages.
#pragma once

#include <optional>
#include <string>

#include "reference/number/rational.hpp"

namespace minkref {

/// The number in plain decimal notation, no exponent ("-30.7428"); none if the denominator has a
/// prime factor other than 2 and 5. Exact.
std::optional<std::string> exact_decimal(const Rational& value);

/// Whether exact_decimal gives a text.
bool has_exact_decimal(const Rational& value);

/// A number for a message, to be read beside the text of a file: a short decimal if possible, else
/// "n/d"; longer text than 60 characters is cut.
std::string message_text(const Rational& value);

}  // namespace minkref
