// Exact rational numbers: Boost.Multiprecision over GMP, expression templates off (so `auto` is
// safe).
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <string_view>

#include "reference/number/float_self_test.hpp"

namespace minkref {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

inline int sign(const Integer& value) { return value.sign(); }
inline int sign(const Rational& value) { return value.sign(); }

/// Limits on the text of one number; a longer number is refused before any work.
struct NumberLimits {
  std::size_t digits = 10'000;  ///< most digits in the text of a number
  long exponent = 10'000;       ///< largest magnitude of a decimal exponent
};

/// The exact number that a text names: "3", "-30.7428", "3/7", "1e-3", "+.5". White space is not
/// skipped; a fraction has two integers, and its sign stands first. Throws BadInput (code
/// "not-a-number": also for nan and inf; "zero-denominator") or LimitExceeded (code
/// "number-too-long", "exponent-too-large"). Exact. Linear in the limits.
Rational parse_rational(std::string_view text, const NumberLimits& limits = {});

/// "n", or "n/d" in lowest terms with d > 1.
std::string to_string(const Rational& value);

/// The nearest double (round half to even; infinity beyond the range of doubles).
double to_double(const Rational& value);

/// The tightest pair of doubles around a value: two equal doubles iff the value is a double. Beyond
/// the doubles' range one bound is the largest finite double and the other an infinity.
struct Enclosure {
  double lower = 0, upper = 0;
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};
Enclosure enclose(const Rational& value);

/// The exact value of a finite double. Throws BadInput (code "not-a-number") for NaN and infinity.
Rational from_double(double value);

}  // namespace minkref
