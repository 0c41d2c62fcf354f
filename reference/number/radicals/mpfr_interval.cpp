#include "reference/number/radicals/mpfr_interval.hpp"

#include <algorithm>

namespace minkref {
namespace {

long larger(const MpfrInterval& a, const MpfrInterval& b) {
  return std::max(a.precision(), b.precision());
}

Rational exact(const mpfr_t& value) {
  Rational result;
  mpfr_get_q(result.backend().data(), value);
  return result;
}

}  // namespace

MpfrInterval::MpfrInterval(long precision) {
  mpfr_init2(low_, precision);
  mpfr_init2(high_, precision);
}

MpfrInterval::MpfrInterval(const Rational& value, long precision) : MpfrInterval(precision) {
  mpfr_set_q(low_, value.backend().data(), MPFR_RNDD);
  mpfr_set_q(high_, value.backend().data(), MPFR_RNDU);
}

MpfrInterval::MpfrInterval(const MpfrInterval& other) : MpfrInterval(other.precision()) {
  mpfr_set(low_, other.low_, MPFR_RNDD);
  mpfr_set(high_, other.high_, MPFR_RNDU);
}

MpfrInterval& MpfrInterval::operator=(const MpfrInterval& other) {
  if (this == &other) return *this;
  mpfr_set_prec(low_, other.precision());
  mpfr_set_prec(high_, other.precision());
  mpfr_set(low_, other.low_, MPFR_RNDD);
  mpfr_set(high_, other.high_, MPFR_RNDU);
  return *this;
}

MpfrInterval::~MpfrInterval() {
  mpfr_clear(low_);
  mpfr_clear(high_);
}

MpfrInterval operator+(const MpfrInterval& a, const MpfrInterval& b) {
  MpfrInterval sum(larger(a, b));
  mpfr_add(sum.low_, a.low_, b.low_, MPFR_RNDD);
  mpfr_add(sum.high_, a.high_, b.high_, MPFR_RNDU);
  return sum;
}

MpfrInterval operator-(const MpfrInterval& a, const MpfrInterval& b) {
  MpfrInterval difference(larger(a, b));
  mpfr_sub(difference.low_, a.low_, b.high_, MPFR_RNDD);
  mpfr_sub(difference.high_, a.high_, b.low_, MPFR_RNDU);
  return difference;
}

MpfrInterval operator*(const MpfrInterval& a, const MpfrInterval& b) {
  MpfrInterval product(larger(a, b)), other(larger(a, b));
  bool is_first = true;
  for (const mpfr_srcptr x : {a.low_, a.high_}) {
    for (const mpfr_srcptr y : {b.low_, b.high_}) {
      mpfr_mul(is_first ? product.low_ : other.low_, x, y, MPFR_RNDD);
      mpfr_mul(is_first ? product.high_ : other.high_, x, y, MPFR_RNDU);
      if (!is_first) {
        mpfr_min(product.low_, product.low_, other.low_, MPFR_RNDD);
        mpfr_max(product.high_, product.high_, other.high_, MPFR_RNDU);
      }
      is_first = false;
    }
  }
  return product;
}

MpfrInterval sqrt(const MpfrInterval& a) {
  MpfrInterval root(a.precision());
  if (mpfr_sgn(a.low_) <= 0) {
    mpfr_set_zero(root.low_, 1);
  } else {
    mpfr_sqrt(root.low_, a.low_, MPFR_RNDD);
  }
  if (mpfr_sgn(a.high_) <= 0) {
    mpfr_set_zero(root.high_, 1);
  } else {
    mpfr_sqrt(root.high_, a.high_, MPFR_RNDU);
  }
  return root;
}

int MpfrInterval::certain_sign() const {
  return mpfr_sgn(low_) > 0 ? 1 : mpfr_sgn(high_) < 0 ? -1 : 0;
}

Rational MpfrInterval::low() const { return exact(low_); }
Rational MpfrInterval::high() const { return exact(high_); }

}  // namespace minkref
