#include "reference/number/rational.hpp"

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/message_number.hpp"

namespace minkref {
namespace {

static_assert(sizeof(unsigned long) == 8, "GMP's _ui functions must take 64 bits");

/// A text as it appears in a message: at most 40 characters, control characters replaced.
std::string quoted(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string shown(text.substr(0, most));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return '"' + shown + '"' + (text.size() > most ? " (cut)" : "");
}

[[noreturn]] void refuse(std::string_view text) {
  throw BadInput("not-a-number", quoted(text) + " is not a number",
                 "write an integer, a decimal or a fraction, such as 3, -30.7428, 1e-3 or 3/7");
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Cuts the leading decimal digits off `rest` and returns them.
std::string_view take_digits(std::string_view& rest) {
  std::size_t count = 0;
  while (count < rest.size() && is_digit(rest[count])) ++count;
  const std::string_view digits = rest.substr(0, count);
  rest.remove_prefix(count);
  return digits;
}

bool take(std::string_view& rest, char c) {
  if (rest.empty() || rest.front() != c) return false;
  rest.remove_prefix(1);
  return true;
}

bool take_sign(std::string_view& rest) {
  if (take(rest, '-')) return true;
  take(rest, '+');
  return false;
}

/// The parts of a number's text, nothing evaluated. Either `denominator` or the last two apply.
struct Parts {
  bool negative = false, is_fraction = false, exponent_negative = false;
  std::string_view whole, denominator, fraction, exponent;
  std::size_t digits() const {
    return whole.size() + denominator.size() + fraction.size() + exponent.size();
  }
};

Parts split(std::string_view text) {
  Parts parts;
  std::string_view rest = text;
  parts.negative = take_sign(rest);
  parts.whole = take_digits(rest);
  if (take(rest, '/')) {
    parts.is_fraction = true;
    parts.denominator = take_digits(rest);
    if (parts.whole.empty() || parts.denominator.empty()) refuse(text);
  } else {
    if (take(rest, '.')) parts.fraction = take_digits(rest);
    if (parts.whole.empty() && parts.fraction.empty()) refuse(text);
    if (take(rest, 'e') || take(rest, 'E')) {
      parts.exponent_negative = take_sign(rest);
      parts.exponent = take_digits(rest);
      if (parts.exponent.empty()) refuse(text);
    }
  }
  if (!rest.empty()) refuse(text);
  return parts;
}

/// The decimal exponent, refused as soon as it passes the limit.
long exponent_of(const Parts& parts, std::string_view text, long limit) {
  long magnitude = 0;
  for (const char c : parts.exponent) {
    const long digit = c - '0';
    if (magnitude > (limit - digit) / 10) {
      throw LimitExceeded("exponent-too-large",
                          "the exponent of " + quoted(text) + " is larger than " +
                              std::to_string(limit) + " in magnitude",
                          "rescale the input, or raise the limit on exponents");
    }
    magnitude = 10 * magnitude + digit;
  }
  return parts.exponent_negative ? -magnitude : magnitude;
}

/// Sets an integer from decimal digits and more behind them (none is zero).
void set_digits(mpz_ptr integer, std::string_view digits, std::string_view more = {}) {
  if (digits.size() + more.size() <= 18) {
    unsigned long value = 0;
    for (const char c : digits) value = 10 * value + static_cast<unsigned long>(c - '0');
    for (const char c : more) value = 10 * value + static_cast<unsigned long>(c - '0');
    mpz_set_ui(integer, value);
  } else {
    mpz_set_str(integer, std::string(digits).append(more).c_str(), 10);
  }
}

void times_power_of_ten(mpz_ptr integer, unsigned long exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), 10, exponent);
  mpz_mul(integer, integer, power.backend().data());
}

/// The nearest double to |n/d| and the sign of |n/d| - nearest.
struct Nearest {
  double value = 0;
  int residual = 0;
};

/// Rounds `quotient` * 2^unit, half to even, to a multiple of 2^lowest; `beyond` says whether
/// something below the quotient's last bit was cut off.
Nearest round_half_even(std::uint64_t quotient, long unit, long lowest, bool beyond) {
  const long cut = lowest - unit;  // bits to drop, 1 to 64 here
  const std::uint64_t kept = cut >= 64 ? 0 : quotient >> cut;
  const std::uint64_t dropped = cut >= 64 ? quotient : quotient & ((std::uint64_t{1} << cut) - 1);
  const std::uint64_t half = std::uint64_t{1} << (cut - 1);
  const bool above = dropped > half || (dropped == half && beyond);
  const bool tie = dropped == half && !beyond;
  const bool up = above || (tie && (kept & 1) != 0);
  const double value =
      std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), static_cast<int>(lowest));
  if (std::isinf(value)) return {value, -1};
  return {value, up ? -1 : (dropped != 0 || beyond ? 1 : 0)};
}

/// |z|, if a double holds every integer as large; else 0.
double small_magnitude(mpz_srcptr z) {
  constexpr mp_limb_t beyond = mp_limb_t{1} << 53;
  if (mpz_size(z) != 1 || mpz_getlimbn(z, 0) > beyond) return 0;
  return static_cast<double>(mpz_getlimbn(z, 0));
}

/// The limbs of |z| 2^shift, and no leading zero.
using Limbs = boost::container::small_vector<mp_limb_t, 24>;
Limbs shifted(mpz_srcptr z, long shift) {
  const std::size_t whole = static_cast<std::size_t>(shift) / 64, size = mpz_size(z);
  const auto rest = static_cast<unsigned>(shift % 64);
  Limbs result(whole + size + 1, 0);
  mp_limb_t* const to = result.data() + whole;
  if (rest == 0) {
    mpn_copyi(to, mpz_limbs_read(z), static_cast<mp_size_t>(size));
  } else {
    to[size] = mpn_lshift(to, mpz_limbs_read(z), static_cast<mp_size_t>(size), rest);
  }
  if (result.back() == 0) result.pop_back();
  return result;
}

/// For numbers within a factor of 2^64 of each other: the quotient of n and d, rounded down, and
/// whether something is left.
std::pair<std::uint64_t, bool> quotient_of(const Limbs& n, const Limbs& d) {
  Limbs quotient(n.size() - d.size() + 1), left(d.size());
  mpn_tdiv_qr(quotient.data(), left.data(), 0, n.data(), static_cast<mp_size_t>(n.size()), d.data(),
              static_cast<mp_size_t>(d.size()));
  return {quotient[0], mpn_zero_p(left.data(), static_cast<mp_size_t>(left.size())) == 0};
}

Nearest nearest_magnitude(const Rational& value) {
  mpz_srcptr n = mpq_numref(value.backend().data());
  mpz_srcptr d = mpq_denref(value.backend().data());
  if (mpz_sgn(n) == 0) return {};
  const double small_n = small_magnitude(n), small_d = small_magnitude(d);
  if (small_n != 0 && small_d != 0) {
    const double nearest = small_n / small_d;
    const double residual = std::fma(-nearest, small_d, small_n);
    return {nearest, residual > 0 ? 1 : residual < 0 ? -1 : 0};
  }
  const auto bits = [](mpz_srcptr z) { return static_cast<long>(mpz_sizeinbase(z, 2)); };
  const long magnitude = bits(n) - bits(d);  // 2^(magnitude-1) < |value| < 2^(magnitude+1)
  if (magnitude > 1025) return {std::numeric_limits<double>::infinity(), -1};
  if (magnitude < -1080) return {0, 1};
  // The quotient has 63 or 64 bits: |n/d| = (quotient + something below 1) 2^-shift.
  const long shift = 63 - magnitude;
  const auto [leading, beyond] =
      quotient_of(shifted(n, std::max(shift, 0L)), shifted(d, std::max(-shift, 0L)));
  // The last place of the result: 53 bits below the first, but never below the smallest double.
  const long first = std::bit_width(leading) - 1 - shift;
  const long lowest = std::max(first - 52, -1074L);
  if (lowest + shift > 64) return {0, 1};  // below half of the smallest double
  return round_half_even(leading, -shift, lowest, beyond);
}

/// Divides all factors `prime` out of `value` and returns their number.
unsigned long remove_factor(Integer& value, unsigned long prime) {
  const Integer factor(prime);
  return mpz_remove(value.backend().data(), value.backend().data(), factor.backend().data());
}

}  // namespace

Rational parse_rational(std::string_view text, const NumberLimits& limits) {
  look_for_interrupt();
  const auto too_long = [&] {
    return LimitExceeded("number-too-long",
                         "the number " + quoted(text) + " has more than " +
                             std::to_string(limits.digits) + " digits",
                         "round the input, or raise the limit on digits");
  };
  // At most four characters of a number are not digits: two signs, the point and the "e".
  if (text.size() > 4 && text.size() - 4 > limits.digits) throw too_long();
  const Parts parts = split(text);
  if (parts.digits() > limits.digits) throw too_long();
  const long exponent = exponent_of(parts, text, limits.exponent);

  Rational value;
  mpz_ptr n = mpq_numref(value.backend().data());
  mpz_ptr d = mpq_denref(value.backend().data());
  set_digits(n, parts.whole, parts.fraction);
  if (parts.is_fraction) {
    set_digits(d, parts.denominator);
    if (mpz_sgn(d) == 0) {
      throw BadInput("zero-denominator", "the denominator of " + quoted(text) + " is zero",
                     "write a fraction with a denominator that is not zero");
    }
  } else if (mpz_sgn(n) != 0) {
    const long power = exponent - static_cast<long>(parts.fraction.size());
    times_power_of_ten(power >= 0 ? n : d, static_cast<unsigned long>(std::labs(power)));
  }
  mpq_canonicalize(value.backend().data());
  if (parts.negative) mpq_neg(value.backend().data(), value.backend().data());
  return value;
}

std::string to_string(const Rational& value) {
  look_for_interrupt();
  mpq_srcptr q = value.backend().data();
  // Room for both parts, two signs, the bar and the end of the text (GMP manual, mpq_get_str).
  std::string text(mpz_sizeinbase(mpq_numref(q), 10) + mpz_sizeinbase(mpq_denref(q), 10) + 3, '\0');
  mpq_get_str(text.data(), 10, q);
  text.resize(text.find('\0'));
  return text;
}

std::optional<std::string> exact_decimal(const Rational& value) {
  look_for_interrupt();
  Integer rest = denominator(value);
  const unsigned long twos = remove_factor(rest, 2);
  const unsigned long fives = remove_factor(rest, 5);
  if (rest != 1) return std::nullopt;
  const unsigned long places = std::max(twos, fives);
  // numerator / (2^a 5^b) = numerator * 2^(k-a) 5^(k-b) / 10^k
  Integer scaled, factor;
  mpz_mul_2exp(scaled.backend().data(), numerator(value).backend().data(), places - twos);
  mpz_ui_pow_ui(factor.backend().data(), 5, places - fives);
  scaled *= factor;
  std::string digits = abs(scaled).str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (sign(value) < 0 ? "-" : "") + digits;
}

bool has_exact_decimal(const Rational& value) {
  Integer rest = denominator(value);
  remove_factor(rest, 2);
  remove_factor(rest, 5);
  return rest == 1;
}

std::string message_text(const Rational& value) {
  constexpr std::size_t most = 60;
  if (const auto text = exact_decimal(value); text && text->size() <= most) return *text;
  const std::string text = to_string(value);
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

double to_double(const Rational& value) {
  const FloatEnvironment standard;
  const double magnitude = nearest_magnitude(value).value;
  return value.sign() < 0 ? -magnitude : magnitude;
}

Enclosure enclose(const Rational& value) {
  const FloatEnvironment standard;
  const Nearest nearest = nearest_magnitude(value);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Enclosure around{nearest.value, nearest.value};
  if (nearest.residual < 0) around.lower = std::nextafter(nearest.value, -infinity);
  if (nearest.residual > 0) around.upper = std::nextafter(nearest.value, infinity);
  if (value.sign() < 0) return {-around.upper, -around.lower};
  return around;
}

Rational from_double(double value) {
  const FloatEnvironment standard;
  if (!std::isfinite(value)) {
    throw BadInput("not-a-number",
                   std::isnan(value) ? "NaN is not a number" : "infinity is not a number",
                   "leave the value out, or replace it by a finite one");
  }
  Rational exact;
  mpq_set_d(exact.backend().data(), value);
  return exact;
}

}  // namespace minkref
