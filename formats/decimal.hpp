// Decimal text of rational numbers.
#pragma once

#include <optional>
#include <string>

#include "reference/number/rational.hpp"

namespace minkref {

/// The number in plain decimal notation, no exponent ("-30.7428"); none where the denominator has a
/// prime factor other than 2 and 5. Exact.
std::optional<std::string> exact_decimal(const Rational& value);

/// Whether exact_decimal gives a text.
bool has_exact_decimal(const Rational& value);

/// exact_decimal, or else the nearest double with 17 significant digits. Throws LimitExceeded
/// ("not-representable") where that double is zero or infinite.
std::string decimal(const Rational& value);

}  // namespace minkref
