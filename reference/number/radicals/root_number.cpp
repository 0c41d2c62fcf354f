#include "reference/number/radicals/root_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/error.hpp"

namespace minkref {
namespace {

using Coefficients = std::vector<Rational>;
/// A field's radicands: the k-th root is the root of a number with 2^k coefficients.
using Radicands = std::vector<Coefficients>;
/// 2^level coefficients from here on: a, then b, of a + b √m.
using Part = const Rational*;

constexpr std::size_t size_of(std::size_t level) { return std::size_t{1} << level; }

Coefficients product(const Radicands& radicands, std::size_t level, Part x, Part y) {
  if (level == 0) return {Rational(*x * *y)};
  const std::size_t half = size_of(level - 1);
  const Part a = x, b = x + half, c = y, d = y + half;
  Coefficients ac = product(radicands, level - 1, a, c);
  const Coefficients bd = product(radicands, level - 1, b, d),
                     bdm = product(radicands, level - 1, bd.data(), radicands[level - 1].data()),
                     ad = product(radicands, level - 1, a, d),
                     bc = product(radicands, level - 1, b, c);
  for (std::size_t k = 0; k < half; ++k) ac[k] += bdm[k];
  for (std::size_t k = 0; k < half; ++k) ac.push_back(ad[k] + bc[k]);
  return ac;
}

/// a² - b² m.
Coefficients norm(const Radicands& radicands, std::size_t level, Part x) {
  const std::size_t half = size_of(level - 1);
  const Part a = x, b = x + half;
  Coefficients square = product(radicands, level - 1, a, a);
  const Coefficients bb = product(radicands, level - 1, b, b),
                     bbm = product(radicands, level - 1, bb.data(), radicands[level - 1].data());
  for (std::size_t k = 0; k < half; ++k) square[k] -= bbm[k];
  return square;
}

int exact_sign(const Radicands& radicands, std::size_t level, Part x) {
  if (level == 0) return x->sign();
  const std::size_t half = size_of(level - 1);
  const int a = exact_sign(radicands, level - 1, x), b = exact_sign(radicands, level - 1, x + half);
  if (b == 0 || a == b) return a;
  const int root = exact_sign(radicands, level - 1, radicands[level - 1].data());
  if (root == 0) return a;
  if (a == 0) return b;
  const Coefficients difference = norm(radicands, level, x);
  return a * exact_sign(radicands, level - 1, difference.data());
}

Interval root_of(const Interval& m) {
  const double low = std::max(m.lower(), 0.0), high = std::max(m.upper(), 0.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double root = std::sqrt(low);
  return {root > 0 ? std::nextafter(root, 0.0) : 0.0, std::nextafter(std::sqrt(high), infinity)};
}

MpfrInterval root_of(const MpfrInterval& m) { return sqrt(m); }

/// The value of a number with 2^level coefficients, from the values of the roots.
template <class Number, class Make>
Number value_of(const std::vector<Number>& roots, std::size_t level, Part x, Make&& make) {
  if (level == 0) return make(*x);
  const std::size_t half = size_of(level - 1);
  const Number a = value_of(roots, level - 1, x, make);
  const bool is_below =
      std::all_of(x + half, x + 2 * half, [](const Rational& c) { return c == 0; });
  if (is_below) return a;
  return a + value_of(roots, level - 1, x + half, make) * roots[level - 1];
}

template <class Number, class Make>
std::vector<Number> roots_of(const Radicands& radicands, Make&& make) {
  std::vector<Number> roots;
  for (std::size_t k = 0; k < radicands.size(); ++k) {
    roots.push_back(root_of(value_of(roots, k, radicands[k].data(), make)));
  }
  return roots;
}

Interval make_interval(const Rational& value) { return Interval(value); }

std::optional<Rational> rational_root(const Rational& value) {
  const Integer n = boost::multiprecision::numerator(value),
                d = boost::multiprecision::denominator(value);
  if (mpz_perfect_square_p(n.backend().data()) == 0 ||
      mpz_perfect_square_p(d.backend().data()) == 0) {
    return std::nullopt;
  }
  return Rational(boost::multiprecision::sqrt(n), boost::multiprecision::sqrt(d));
}

}  // namespace

std::shared_ptr<const RootField> RootField::rationals() {
  static const std::shared_ptr<const RootField> field(new RootField());
  return field;
}

std::shared_ptr<const RootField> RootField::with_root_of(const RootNumber& radicand) {
  const auto& base = radicand.field();
  if (base->roots() == most_roots) {
    throw LimitExceeded("too-many-roots",
                        "a number has more than " + std::to_string(most_roots) + " square roots",
                        "this is a fault of minkref: report it");
  }
  if (sign(radicand) < 0) throw std::domain_error("the square root of a negative number");
  auto field = std::shared_ptr<RootField>(new RootField());
  field->base_ = base;
  field->radicands_ = base->radicands_;
  field->radicands_.push_back(radicand.coefficients());
  field->rounded_ = roots_of<Interval>(field->radicands_, make_interval);
  return field;
}

RootNumber::RootNumber(const Rational& value)
    : field_(RootField::rationals()), coefficients_{value} {}

RootNumber sqrt(const RootNumber& value) {
  if (value.field()->roots() == 0) {
    if (value.coefficients()[0] < 0)
      throw std::domain_error("the square root of a negative number");
    if (const auto root = rational_root(value.coefficients()[0])) return *root;
  }
  const auto field = RootField::with_root_of(value);
  std::vector<Rational> coefficients(size_of(field->roots()));
  coefficients[size_of(field->roots() - 1)] = 1;
  return {field, std::move(coefficients)};
}

RootNumber RootNumber::in(const std::shared_ptr<const RootField>& field) const {
  for (const RootField* base = field.get(); base != nullptr; base = base->base_.get()) {
    if (base != field_.get()) continue;
    std::vector<Rational> coefficients = coefficients_;
    coefficients.resize(size_of(field->roots()));
    return {field, std::move(coefficients)};
  }
  throw std::logic_error("a number is not of the field that it is to be taken to");
}

std::shared_ptr<const RootField> RootNumber::common(const RootNumber& a, const RootNumber& b) {
  return a.field_->roots() < b.field_->roots() ? b.field_ : a.field_;
}

RootNumber operator-(const RootNumber& a) {
  RootNumber result = a;
  for (Rational& c : result.coefficients_) c = -c;
  return result;
}

RootNumber operator+(const RootNumber& a, const RootNumber& b) {
  const auto field = RootNumber::common(a, b);
  RootNumber sum = a.in(field);
  const RootNumber other = b.in(field);
  for (std::size_t k = 0; k < sum.coefficients_.size(); ++k) {
    sum.coefficients_[k] += other.coefficients_[k];
  }
  return sum;
}

RootNumber operator-(const RootNumber& a, const RootNumber& b) { return a + -b; }

RootNumber operator*(const RootNumber& a, const RootNumber& b) {
  const auto field = RootNumber::common(a, b);
  const RootNumber x = a.in(field), y = b.in(field);
  return {field, product(field->radicands(), field->roots(), x.coefficients_.data(),
                         y.coefficients_.data())};
}

RootNumber operator/(const RootNumber& a, const RootNumber& b) {
  if (sign(b) == 0) throw std::domain_error("division by zero");
  // b = u + v √m: b times its conjugate belongs to the field below; if the product is 0, b = 2 u.
  RootNumber top = a, bottom = b;
  while (bottom.field_->roots() > 0) {
    const auto below = bottom.field_->base();
    const auto half = static_cast<std::ptrdiff_t>(size_of(below->roots()));
    RootNumber conjugate = bottom;
    for (auto c = conjugate.coefficients_.begin() + half; c != conjugate.coefficients_.end(); ++c) {
      *c = -*c;
    }
    RootNumber reduced{below, norm(bottom.field_->radicands(), bottom.field_->roots(),
                                   bottom.coefficients_.data())};
    if (sign(reduced) == 0) {
      reduced.coefficients_.assign(bottom.coefficients_.begin(),
                                   bottom.coefficients_.begin() + half);
      for (Rational& c : reduced.coefficients_) c *= 2;
    } else {
      top = top * conjugate;
    }
    bottom = std::move(reduced);
  }
  const Rational inverse = 1 / bottom.coefficients_[0];
  for (Rational& c : top.coefficients_) c *= inverse;
  return top;
}

int sign(const RootNumber& value) {
  const auto& field = *value.field();
  if (field.roots() == 0) return value.coefficients()[0].sign();
  const Interval rounded = value.enclosure();
  if (rounded.lower() > 0) return 1;
  if (rounded.upper() < 0) return -1;
  constexpr long bits = 192;
  if (const int certain = value.enclosure(bits).certain_sign(); certain != 0) return certain;
  return exact_sign(field.radicands(), field.roots(), value.coefficients().data());
}

Interval RootNumber::enclosure() const {
  return value_of(field_->rounded_, field_->roots(), coefficients_.data(), make_interval);
}

MpfrInterval RootNumber::enclosure(long precision) const {
  const auto make = [&](const Rational& value) { return MpfrInterval(value, precision); };
  const auto roots = roots_of<MpfrInterval>(field_->radicands(), make);
  return value_of(roots, field_->roots(), coefficients_.data(), make);
}

std::vector<Rational> RootNumber::polynomial() const {
  // Starts with X - x and multiplies by its conjugate for each root, from the last root to the
  // first.
  std::size_t level = field_->roots();
  std::vector<Coefficients> terms(2, Coefficients(size_of(level)));
  for (std::size_t k = 0; k < size_of(level); ++k) terms[0][k] = -coefficients_[k];
  terms[1][0] = 1;
  for (; level > 0; --level) {
    std::vector<Coefficients> conjugate = terms;
    for (Coefficients& term : conjugate) {
      for (std::size_t k = size_of(level - 1); k < size_of(level); ++k) term[k] = -term[k];
    }
    std::vector<Coefficients> squared(2 * terms.size() - 1, Coefficients(size_of(level)));
    for (std::size_t i = 0; i < terms.size(); ++i) {
      for (std::size_t j = 0; j < conjugate.size(); ++j) {
        const Coefficients part =
            product(field_->radicands(), level, terms[i].data(), conjugate[j].data());
        for (std::size_t k = 0; k < part.size(); ++k) squared[i + j][k] += part[k];
      }
    }
    for (Coefficients& term : squared) term.resize(size_of(level - 1));  // the rest is zero
    terms = std::move(squared);
  }
  std::vector<Rational> found;
  for (const Coefficients& term : terms) found.push_back(term[0]);
  return found;
}

}  // namespace minkref
