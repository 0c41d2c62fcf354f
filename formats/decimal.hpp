// Decimal text for rational numbers.
#pragma once

#include <string>

#include "reference/number/message_number.hpp"

namespace minkref {

/// exact_decimal, or else the nearest double with 17 significant digits. Throws LimitExceeded
/// ("not-representable") if this double is zero or infinite.
std::string decimal(const Rational& value);

}  // namespace minkref
