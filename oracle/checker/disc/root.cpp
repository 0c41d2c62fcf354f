#include "oracle/checker/disc/root.hpp"

namespace minkref::checker {
namespace {

/// p + q √d, with its sign.
struct Pair {
  mpq_class p, q;
};
Pair times(const Pair& x, const Pair& y, const mpq_class& d) {
  return {x.p * y.p + x.q * y.q * d, x.p * y.q + x.q * y.p};
}
Pair minus(const Pair& x, const Pair& y) { return {x.p - y.p, x.q - y.q}; }

/// The sign of p + q √d, from those of p, q and p² - q² d.
template <class Squares>
int joined(int p, int q, const Squares& sign_of_squares) {
  if (p * q >= 0) return p != 0 ? p : q;
  return p * sign_of_squares();
}

int sign(const Pair& x, const mpq_class& d) {
  return joined(sgn(x.p), sgn(x.q), [&] { return sgn(mpq_class(x.p * x.p - x.q * x.q * d)); });
}

}  // namespace

Root operator+(const Root& x, const Root& y) {
  Root sum = x;
  if (sum.field_ == nullptr) sum.field_ = y.field_;
  for (int i = 0; i < 4; ++i) sum.p_[i] += y.p_[i];
  return sum;
}

Root operator-(const Root& x, const Root& y) { return x + y * Root(-1); }

Root operator*(const Root& x, const Root& y) {
  const auto& field = x.field_ != nullptr ? x.field_ : y.field_;
  if (x.field_ == nullptr || y.field_ == nullptr) {
    const Root& root = x.field_ != nullptr ? x : y;
    const mpq_class& factor = (x.field_ != nullptr ? y : x).p_[0];
    return {field, root.p_[0] * factor, root.p_[1] * factor, root.p_[2] * factor,
            root.p_[3] * factor};
  }
  const Pair a{x.p_[0], x.p_[1]}, b{x.p_[2], x.p_[3]}, c{y.p_[0], y.p_[1]}, d{y.p_[2], y.p_[3]};
  const mpq_class& first = field->first;
  const Pair ac = times(a, c, first), ad = times(a, d, first), bc = times(b, c, first);
  const Pair bd = times(times(b, d, first), {field->base, field->part}, first);
  return {field, ac.p + bd.p, ac.q + bd.q, ad.p + bc.p, ad.q + bc.q};
}

int sign(const Root& x) {
  if (x.field_ == nullptr) return sgn(x.p_[0]);
  const mpq_class& first = x.field_->first;
  const Pair p{x.p_[0], x.p_[1]}, q{x.p_[2], x.p_[3]};
  return joined(sign(p, first), sign(q, first), [&] {
    const Pair square = times(times(q, q, first), {x.field_->base, x.field_->part}, first);
    return sign(minus(times(p, p, first), square), first);
  });
}

}  // namespace minkref::checker
