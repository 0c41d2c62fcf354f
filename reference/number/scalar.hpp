// The geometry's demands on a number, and the four models: Rational, Interval, Mpfr, double.
//
// `sign` answers with -1, 0 or 1. A Rational's sign is exact; an Interval certifies its sign or
// throws UndecidedSign; an Mpfr and a double give the sign of the rounded value, and throw
// UndecidedSign for NaN. `approximate` gives a double for drawing, never for deciding.
#pragma once

#include <cmath>
#include <concepts>
#include <string>

#include "reference/error.hpp"
#include "reference/number/interval.hpp"
#include "reference/number/mpfr.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

inline int sign(double value) {
  if (std::isnan(value)) throw UndecidedSign();
  return (value > 0) - (value < 0);
}

inline double approximate(double value) { return value; }
inline double approximate(const Rational& value) { return to_double(value); }

/// Takes exact numbers to the scalar T: the entrance of a computation with T. `name()` is the
/// command line's word. Specialised for the four models.
template <class T>
class Arithmetic;

/// Exact; the identity.
template <>
class Arithmetic<Rational> {
 public:
  Rational operator()(const Rational& value) const { return value; }
  std::string name() const { return "rational"; }
};

/// The tightest enclosure.
template <>
class Arithmetic<Interval> {
 public:
  Interval operator()(const Rational& value) const { return Interval(value); }
  std::string name() const { return "interval"; }
};

/// The nearest value with `precision` bits. The constructor throws as Mpfr's does.
template <>
class Arithmetic<Mpfr> {
 public:
  explicit Arithmetic(long precision = 53) : precision_(Mpfr(0.0, precision).precision()) {}
  Mpfr operator()(const Rational& value) const { return {value, precision_}; }
  long precision() const { return precision_; }
  std::string name() const { return "mpfr:" + std::to_string(precision_); }

 private:
  long precision_;
};

/// The nearest double.
template <>
class Arithmetic<double> {
 public:
  double operator()(const Rational& value) const { return to_double(value); }
  std::string name() const { return "double"; }
};

/// A number that the geometry can be written against. Default construction gives zero; integers
/// convert exactly. Ordering is not required: compare by the sign of a difference.
template <class T>
concept Scalar =
    std::default_initializable<T> && std::copyable<T> && std::constructible_from<T, int> &&
    requires(T value, const T& a, const T& b, const Arithmetic<T>& arithmetic,
             const Rational& exact) {
      { a + b } -> std::convertible_to<T>;
      { a - b } -> std::convertible_to<T>;
      { a* b } -> std::convertible_to<T>;
      { a / b } -> std::convertible_to<T>;
      { -a } -> std::convertible_to<T>;
      value += a;
      value -= a;
      value *= a;
      value /= a;
      { sign(a) } -> std::same_as<int>;
      { approximate(a) } -> std::same_as<double>;
      { arithmetic(exact) } -> std::same_as<T>;
      { arithmetic.name() } -> std::same_as<std::string>;
    };

static_assert(Scalar<Rational> && Scalar<Interval> && Scalar<Mpfr> && Scalar<double>);

}  // namespace minkref
