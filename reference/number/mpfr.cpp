#include "reference/number/mpfr.hpp"

#include <algorithm>
#include <bit>

#include "reference/error.hpp"

namespace minkref {
namespace {

long checked(long precision) {
  if (precision < 1) {
    throw BadInput("precision", "a precision of " + std::to_string(precision) + " bits",
                   "ask for at least 1 bit");
  }
  if (precision > Mpfr::largest_precision) {
    throw LimitExceeded("precision-too-large",
                        "a precision of " + std::to_string(precision) + " bits is beyond the limit",
                        "ask for at most " + std::to_string(Mpfr::largest_precision) + " bits");
  }
  return precision;
}

/// The smallest precision that holds an integer exactly.
long bits_of(std::uint64_t magnitude) {
  if (magnitude == 0) return MPFR_PREC_MIN;
  return std::max<long>(MPFR_PREC_MIN, std::bit_width(magnitude) - std::countr_zero(magnitude));
}

}  // namespace

Mpfr::Mpfr(Integral value) : Mpfr(Bits{bits_of(value.magnitude)}) {
  static_assert(sizeof(unsigned long) == 8);
  mpfr_set_ui(value_, value.magnitude, MPFR_RNDN);
  if (value.negative) mpfr_neg(value_, value_, MPFR_RNDN);
}

Mpfr::Mpfr(double value, long precision) : Mpfr(Bits{checked(precision)}) {
  mpfr_set_d(value_, value, MPFR_RNDN);
}

Mpfr::Mpfr(const Rational& value, long precision) : Mpfr(Bits{checked(precision)}) {
  mpfr_set_q(value_, value.backend().data(), MPFR_RNDN);
}

Mpfr::Mpfr(const Mpfr& other) {
  if (other.is_short()) {
    *value_ = *other.value_;
    limbs_ = other.limbs_;
    mpfr_custom_move(value_, limbs_.data());
  } else {
    begin(other.precision());
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
}

Mpfr& Mpfr::operator=(const Mpfr& other) {
  if (this != &other) *this = Mpfr(other);
  return *this;
}

Mpfr& Mpfr::operator=(Mpfr&& other) noexcept {
  if (this != &other) {
    end();
    take(other);
  }
  return *this;
}

Mpfr operator-(const Mpfr& a) {
  Mpfr result(Mpfr::Bits{a.precision()});
  mpfr_neg(result.value_, a.value_, MPFR_RNDN);
  return result;
}

Mpfr operator+(const Mpfr& a, const Mpfr& b) {
  Mpfr result(Mpfr::Bits{std::max(a.precision(), b.precision())});
  mpfr_add(result.value_, a.value_, b.value_, MPFR_RNDN);
  return result;
}

Mpfr operator-(const Mpfr& a, const Mpfr& b) {
  Mpfr result(Mpfr::Bits{std::max(a.precision(), b.precision())});
  mpfr_sub(result.value_, a.value_, b.value_, MPFR_RNDN);
  return result;
}

Mpfr operator*(const Mpfr& a, const Mpfr& b) {
  Mpfr result(Mpfr::Bits{std::max(a.precision(), b.precision())});
  mpfr_mul(result.value_, a.value_, b.value_, MPFR_RNDN);
  return result;
}

Mpfr operator/(const Mpfr& a, const Mpfr& b) {
  Mpfr result(Mpfr::Bits{std::max(a.precision(), b.precision())});
  mpfr_div(result.value_, a.value_, b.value_, MPFR_RNDN);
  return result;
}

Mpfr sqrt(const Mpfr& a) {
  Mpfr result(Mpfr::Bits{a.precision()});
  mpfr_sqrt(result.value_, a.value_, MPFR_RNDN);
  return result;
}

std::partial_ordering operator<=>(const Mpfr& a, const Mpfr& b) {
  if (mpfr_unordered_p(a.value_, b.value_) != 0) return std::partial_ordering::unordered;
  return mpfr_cmp(a.value_, b.value_) <=> 0;
}

int sign(const Mpfr& value) {
  if (mpfr_nan_p(value.value_) != 0) throw UndecidedSign();
  const int order = mpfr_sgn(value.value_);
  return (order > 0) - (order < 0);
}

Rational exact(const Mpfr& value) {
  if (mpfr_number_p(value.value_) == 0) {
    throw BadInput("not-a-number", "NaN and infinity have no exact value",
                   "raise the precision, or see where a division by zero came from");
  }
  if (mpfr_zero_p(value.value_) == 0 && std::labs(mpfr_get_exp(value.value_)) > (1L << 24)) {
    throw LimitExceeded("exponent-too-large", "the number is beyond 2^(+-2^24)",
                        "rescale the input");
  }
  Rational result;
  mpfr_get_q(result.backend().data(), value.value_);
  return result;
}

}  // namespace minkref
