// Intervals between two numbers of a precision in bits: bounds are rounded outwards by MPFR.
#pragma once

#include <mpfr.h>

#include "reference/number/rational.hpp"

namespace minkref {

/// Holds the exact result of each operation. No state of the process is read or written.
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
  /// Of the part that is not below 0; the number is not.
  friend MpfrInterval sqrt(const MpfrInterval& a);

  /// 1 or -1 where that is certain, 0 where it is not or both bounds are 0.
  int certain_sign() const;
  bool is_below(const MpfrInterval& other) const { return mpfr_less_p(high_, other.low_) != 0; }
  Rational low() const;
  Rational high() const;

 private:
  explicit MpfrInterval(long precision);

  mpfr_t low_, high_;
};

MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator-(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b);
MpfrInterval sqrt(const MpfrInterval& a);

}  // namespace minkref
