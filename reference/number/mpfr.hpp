// Floating-point numbers of a precision in bits chosen at run time, value by value: MPFR.
//
// The paper computes with such numbers (Behar & Lien 2012, Sec. 4.2.2). They round, so they decide
// nothing here: they show what this arithmetic answers. Each value carries its precision; the
// process state (MPFR's default precision, exponent range or rounding mode) is neither read nor
// written. Results equal IEEE 754 arithmetic with as many bits of significand, rounded to nearest,
// ties to even, within the exponent range of the IEEE format: MPFR's own range is far larger.
#pragma once

#include <mpfr.h>

#include <array>
#include <compare>
#include <concepts>
#include <cstdint>
#include <string>

#include "reference/number/rational.hpp"

namespace minkref {

class Mpfr {
 public:
  /// The most bits of significand for one value.
  static constexpr long largest_precision = 1L << 24;

  /// Zero, at the smallest precision: it never lowers or raises the precision of a result.
  Mpfr() : Mpfr(0) {}

  /// The integer, exactly, at the smallest sufficient precision: a literal beside a value of more
  /// bits takes that value's precision. (1 / 3 between two literals has two bits: avoid it.)
  template <std::integral T>
  Mpfr(T value)  // NOLINT: implicit, since it is exact
      : Mpfr(Integral{value < T{0}, value < T{0} ? 0 - static_cast<std::uint64_t>(value)
                                                 : static_cast<std::uint64_t>(value)}) {}

  Mpfr(double) = delete;  // would be cut to an integer: give a precision

  /// The double or rational, rounded to nearest. Throws BadInput (code "precision") or
  /// LimitExceeded (code "precision-too-large") unless 1 <= precision <= largest_precision.
  Mpfr(double value, long precision);
  Mpfr(const Rational& value, long precision);

  Mpfr(const Mpfr& other);
  Mpfr(Mpfr&& other) noexcept { take(other); }
  Mpfr& operator=(const Mpfr& other);  ///< takes over the precision too
  Mpfr& operator=(Mpfr&& other) noexcept;
  ~Mpfr() { end(); }

  long precision() const { return mpfr_get_prec(value_); }

  friend Mpfr operator-(const Mpfr& a);
  // Rounded to nearest at the larger precision of the two. Division by zero gives an infinity or
  // NaN.
  friend Mpfr operator+(const Mpfr& a, const Mpfr& b);
  friend Mpfr operator-(const Mpfr& a, const Mpfr& b);
  friend Mpfr operator*(const Mpfr& a, const Mpfr& b);
  friend Mpfr operator/(const Mpfr& a, const Mpfr& b);
  /// The root, rounded to nearest; NaN for a negative number.
  friend Mpfr sqrt(const Mpfr& a);
  Mpfr& operator+=(const Mpfr& other) { return *this = *this + other; }
  Mpfr& operator-=(const Mpfr& other) { return *this = *this - other; }
  Mpfr& operator*=(const Mpfr& other) { return *this = *this * other; }
  Mpfr& operator/=(const Mpfr& other) { return *this = *this / other; }

  /// Comparison of values; precisions do not matter. Exact.
  friend bool operator==(const Mpfr& a, const Mpfr& b) {
    return mpfr_equal_p(a.value_, b.value_) != 0;
  }
  friend std::partial_ordering operator<=>(const Mpfr& a, const Mpfr& b);

  /// The sign of the rounded value; throws UndecidedSign for NaN.
  friend int sign(const Mpfr& value);
  /// Neither NaN nor an infinity.
  friend bool is_finite(const Mpfr& value) { return mpfr_number_p(value.value_) != 0; }

  /// The nearest double.
  friend double approximate(const Mpfr& value) { return mpfr_get_d(value.value_, MPFR_RNDN); }

  /// The exact value. Throws BadInput (code "not-a-number") for NaN and infinity, LimitExceeded
  /// (code "exponent-too-large") beyond 2^(+-2^24).
  friend Rational exact(const Mpfr& value);

 private:
  struct Bits {
    long count;
  };
  struct Integral {
    bool negative;
    std::uint64_t magnitude;
  };
  explicit Mpfr(Integral value);
  explicit Mpfr(Bits precision) { begin(precision.count); }

  // The digits of short numbers stand in the object itself, for which MPFR has its custom
  // interface: taking memory for each result costs more than the arithmetic.
  static constexpr int short_limbs = 4;
  static constexpr long short_precision = static_cast<long>(short_limbs) * GMP_NUMB_BITS;

  bool is_short() const { return precision() <= short_precision; }
  /// Not a number yet.
  void begin(long precision) {
    if (precision <= short_precision) {
      mpfr_custom_init_set(value_, MPFR_NAN_KIND, 0, precision, limbs_.data());
    } else {
      mpfr_init2(value_, precision);
    }
  }
  void end() {
    if (!is_short()) mpfr_clear(value_);
  }
  /// Takes the value of `other`; a long `other` becomes zero, without memory. Requires that no
  /// value is here yet.
  void take(Mpfr& other) noexcept {
    *value_ = *other.value_;
    if (is_short()) {
      limbs_ = other.limbs_;
      mpfr_custom_move(value_, limbs_.data());
    } else {
      mpfr_custom_init_set(other.value_, MPFR_ZERO_KIND, 0, MPFR_PREC_MIN, other.limbs_.data());
    }
  }

  mpfr_t value_;
  std::array<mp_limb_t, short_limbs> limbs_{};
};

Mpfr operator-(const Mpfr& a);
Mpfr operator+(const Mpfr& a, const Mpfr& b);
Mpfr operator-(const Mpfr& a, const Mpfr& b);
Mpfr operator*(const Mpfr& a, const Mpfr& b);
Mpfr operator/(const Mpfr& a, const Mpfr& b);
Mpfr sqrt(const Mpfr& a);
std::partial_ordering operator<=>(const Mpfr& a, const Mpfr& b);
bool is_finite(const Mpfr& value);
int sign(const Mpfr& value);
Rational exact(const Mpfr& value);

}  // namespace minkref
