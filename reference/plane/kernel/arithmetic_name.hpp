// From an arithmetic's name, as the command line spells it, to its scalar type.
#pragma once

#include <optional>
#include <string>

#include "reference/number/scalar.hpp"

namespace minkref::inline plane {

/// The bits of a name "mpfr:BITS"; none for other known names. Throws BadInput (code
/// "unknown-arithmetic") for unknown names, and for fewer than 2 or more than 1,000,000 bits.
std::optional<long> mpfr_bits(const std::string& name);

/// Calls use(Arithmetic<T>) with T by name: rational, interval, double or mpfr:BITS.
template <class Use>
auto with_arithmetic(const std::string& name, Use&& use) {
  if (name == "rational") return use(Arithmetic<Rational>{});
  if (name == "interval") return use(Arithmetic<Interval>{});
  if (name == "double") return use(Arithmetic<double>{});
  return use(Arithmetic<Mpfr>(*mpfr_bits(name)));
}

}  // namespace minkref::inline plane
