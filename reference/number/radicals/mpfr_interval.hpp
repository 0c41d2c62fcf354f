// Intervals between two numbers of a chosen precision: MPFR rounds the bounds outwards.
#pragma once

#include <mpfr.h>

#include "reference/number/rational.hpp"

namespace minkref {

/// Holds the exact result of each operation. Process state is neither read nor written.
class MpfrInterval {
 public:
  MpfrInterval(const Rational& value, long precision);
  MpfrInterval(const MpfrInterval& other);
  MpfrInterval& operator=(const MpfrInterval& other);
  ~MpfrInterval();

  long precision() const { return mpfr_get_prec(low_); }

  friend MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b);
  friend MpfrInterval operator-(const MpfrInterval& a, const MpfrInterval& b);
  friend MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b);
  /// The whole line where the divisor contains zero.
  friend MpfrInterval operator/(const MpfrInterval& a, const MpfrInterval& b);
  friend MpfrInterval operator-(const MpfrInterval& a);
  /// The root of the part of `a` that is not negative.
  friend MpfrInterval sqrt(const MpfrInterval& a);
  /// The angle of (x, y), between -π and π. From -4 to 4, that is unknown, where x's interval
  /// reaches below 0 and y's contains 0.
  friend MpfrInterval atan2(const MpfrInterval& y, const MpfrInterval& x);

  /// 1 or -1 if certain; 0 if uncertain, or if both bounds are 0.
  int certain_sign() const;
  /// Whether all numbers of the interval are nearer to 0 than 2^exponent.
  bool is_within(long exponent) const;
  bool is_below(const MpfrInterval& other) const { return mpfr_less_p(high_, other.low_) != 0; }
  Rational low() const;
  Rational high() const;

  /// The doubles nearest to the bounds, and the next doubles on the bounds' outer sides. An
  /// infinity beyond the range of doubles; no -0.
  Enclosure nearest() const;
  /// Whether the interval lies between two numbers, and neither is a bound.
  bool is_strictly_between(double low, double high) const {
    return mpfr_cmp_d(low_, low) > 0 && mpfr_cmp_d(high_, high) < 0;
  }
  Enclosure outwards() const;

 private:
  explicit MpfrInterval(long precision);

  mpfr_t low_, high_;
};

MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator-(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator/(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator-(const MpfrInterval& a);
MpfrInterval sqrt(const MpfrInterval& a);
MpfrInterval atan2(const MpfrInterval& y, const MpfrInterval& x);

}  // namespace minkref
