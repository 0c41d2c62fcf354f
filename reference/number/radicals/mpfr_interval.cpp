#include "reference/number/radicals/mpfr_interval.hpp"

#include <algorithm>
#include <array>

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

/// Takes into [low, high] the results of `act` at the four corners of the box a x b, rounded
/// outwards.
template <class Act>
void take_hull(mpfr_ptr low, mpfr_ptr high, std::array<mpfr_srcptr, 2> a,
               std::array<mpfr_srcptr, 2> b, Act act) {
  act(low, a[0], b[0], MPFR_RNDD);
  act(high, a[0], b[0], MPFR_RNDU);
  mpfr_t other;
  mpfr_init2(other, mpfr_get_prec(low));
  for (int corner = 1; corner < 4; ++corner) {
    const mpfr_srcptr x = a[corner & 1], y = b[corner >> 1];
    act(other, x, y, MPFR_RNDD);
    mpfr_min(low, low, other, MPFR_RNDD);
    act(other, x, y, MPFR_RNDU);
    mpfr_max(high, high, other, MPFR_RNDU);
  }
  mpfr_clear(other);
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
  MpfrInterval product(larger(a, b));
  take_hull(product.low_, product.high_, {a.low_, a.high_}, {b.low_, b.high_}, mpfr_mul);
  return product;
}

MpfrInterval operator-(const MpfrInterval& a) {
  MpfrInterval negative(a.precision());
  mpfr_neg(negative.low_, a.high_, MPFR_RNDD);
  mpfr_neg(negative.high_, a.low_, MPFR_RNDU);
  return negative;
}

MpfrInterval operator/(const MpfrInterval& a, const MpfrInterval& b) {
  MpfrInterval inverse(larger(a, b));
  if (b.certain_sign() == 0) {
    mpfr_set_inf(inverse.low_, -1);
    mpfr_set_inf(inverse.high_, 1);
    return inverse;
  }
  mpfr_ui_div(inverse.low_, 1, b.high_, MPFR_RNDD);
  mpfr_ui_div(inverse.high_, 1, b.low_, MPFR_RNDU);
  return a * inverse;
}

MpfrInterval atan2(const MpfrInterval& y, const MpfrInterval& x) {
  MpfrInterval angle(larger(x, y));
  if (mpfr_sgn(x.low_) <= 0 && y.certain_sign() == 0) {
    mpfr_set_si(angle.low_, -4, MPFR_RNDD);
    mpfr_set_si(angle.high_, 4, MPFR_RNDU);
    return angle;
  }
  // On a box that leaves out the origin and the negative axis the ends are at corners.
  take_hull(angle.low_, angle.high_, {y.low_, y.high_}, {x.low_, x.high_}, mpfr_atan2);
  return angle;
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

bool MpfrInterval::is_within(long exponent) const {
  const auto is_small = [&](mpfr_srcptr bound) {
    return mpfr_zero_p(bound) != 0 ||
           (mpfr_regular_p(bound) != 0 && mpfr_get_exp(bound) <= exponent);
  };
  return is_small(low_) && is_small(high_);
}

Rational MpfrInterval::low() const { return exact(low_); }
Rational MpfrInterval::high() const { return exact(high_); }

Enclosure MpfrInterval::nearest() const {
  return {mpfr_get_d(low_, MPFR_RNDN) + 0.0, mpfr_get_d(high_, MPFR_RNDN) + 0.0};
}
Enclosure MpfrInterval::outwards() const {
  return {mpfr_get_d(low_, MPFR_RNDD) + 0.0, mpfr_get_d(high_, MPFR_RNDU) + 0.0};
}

}  // namespace minkref
