// Intervals with double bounds that enclose the exact result, without changing the rounding mode.
//
// Each bound of + - * / is the exact bound if this is a double, else the next double outwards: an
// exact operation on points gives a point. Laws: an expression's result encloses its exact value; a
// returned sign is right. NaN never appears; a bound may be infinite. Making an interval of numbers
// throws UnsafeFloats where the thread does not round to nearest or flushes subnormal numbers: hold
// a FloatEnvironment while you compute.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>

#include "reference/error.hpp"
#include "reference/number/error_free.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

class Interval {
 public:
  Interval() = default;

  /// The point `value`; the whole line for NaN and the infinities, which name no real number.
  Interval(double value)  // NOLINT: implicit, since it is exact
      : Interval(std::isfinite(value) ? Interval(value, value, Trusted{}) : whole()) {
    FloatEnvironment::require();
  }

  /// The integer as a point, or the tightest enclosure of an integer that is no double.
  template <std::integral T>
  Interval(T value) {  // NOLINT: implicit
    if constexpr (sizeof(T) < 8) {
      lower_ = upper_ = static_cast<double>(value);
    } else {
      *this = Interval(Rational(value));
    }
  }

  /// The tightest enclosure.
  explicit Interval(const Rational& value) : Interval(enclose(value)) {}
  explicit Interval(const Enclosure& bounds) : Interval(bounds.lower, bounds.upper, Trusted{}) {
    FloatEnvironment::require();
  }

  /// [lower, upper]; the whole line if either is NaN. Throws BadInput (code "empty-interval") for
  /// bounds out of order, and for two equal infinities.
  Interval(double lower, double upper) {
    FloatEnvironment::require();
    if (std::isnan(lower) || std::isnan(upper)) {
      *this = whole();
    } else if (lower > upper || lower == infinity || upper == -infinity) {
      throw BadInput("empty-interval", "the bounds of an interval hold no number between them",
                     "give the smaller bound first");
    } else {
      lower_ = lower;
      upper_ = upper;
    }
  }

  static Interval whole() { return {-infinity, infinity, Trusted{}}; }

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool is_point() const { return lower_ == upper_; }
  bool contains_zero() const { return lower_ <= 0 && upper_ >= 0; }

  friend Interval operator-(const Interval& a) { return {-a.upper_, -a.lower_, Trusted{}}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return {sum_below(a.lower_, b.lower_), sum_above(a.upper_, b.upper_), Trusted{}};
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (a.is_point() && b.is_point()) return point_product(a.lower_, b.lower_);
    if (a.straddles_zero() || b.straddles_zero()) return hull_of_corners(a, b);
    // The corners that bound the product follow from the signs: selections, not branches.
    const bool a_positive = a.lower_ >= 0, b_positive = b.lower_ >= 0;
    return {product_below(b_positive ? a.lower_ : a.upper_, a_positive ? b.lower_ : b.upper_),
            product_above(b_positive ? a.upper_ : a.lower_, a_positive ? b.upper_ : b.lower_),
            Trusted{}};
  }
  /// The whole line where the divisor contains zero: nothing is known, and `sign` will say so.
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.lower_ > 0) return over_positive(a, b);
    if (b.upper_ < 0) return over_positive(-a, -b);
    return whole();
  }

  /// The root of the part of `a` that is not negative. Bounds lie within one double of the tightest
  /// ones, and form a point if the root is a double.
  friend Interval sqrt(const Interval& a) {
    return {root_below(a.lower_), a.upper_ > 0 ? root_above(a.upper_) : 0, Trusted{}};
  }

  Interval& operator+=(const Interval& other) { return *this = *this + other; }
  Interval& operator-=(const Interval& other) { return *this = *this - other; }
  Interval& operator*=(const Interval& other) { return *this = *this * other; }
  Interval& operator/=(const Interval& other) { return *this = *this / other; }

 private:
  struct Trusted {};  // bounds in order, no NaN
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Interval(double lower, double upper, Trusted) : lower_(lower), upper_(upper) {}

  bool straddles_zero() const { return lower_ < 0 && upper_ > 0; }

  // The largest double <= the exact result, from the finite rounded result and the exact result's
  // side of it. Branch-free, since the side is as good as random. `above` mirrors it.
  static double below(double rounded, double residual) {
    if (rounded == 0) return residual < 0 ? -std::numeric_limits<double>::denorm_min() : 0;
    const auto bits = std::bit_cast<std::int64_t>(rounded);
    const std::int64_t step = (bits >> 63) | 1;  // -1 for negative numbers, else 1
    return std::bit_cast<double>(bits - (step & -static_cast<std::int64_t>(residual < 0)));
  }
  static double above(double rounded, double residual) { return -below(-rounded, -residual); }

  static double sum_below(double a, double b) {
    const double sum = a + b;
    if (sum == infinity) return std::numeric_limits<double>::max();  // lower bounds are never +inf
    if (sum == -infinity) return sum;
    return below(sum, error_free::sum_residual(a, b, sum));
  }
  static double sum_above(double a, double b) { return -sum_below(-a, -b); }

  // Zero times an infinite bound is zero: the bound stands for arbitrarily large real numbers.
  static double product_below(double a, double b) {
    if (a == 0 || b == 0) return 0;
    const double product = a * b;
    if (std::abs(product) == infinity) return infinite_below(product, a, b);
    return below(product, error_free::product_residual(a, b, product));
  }
  static double product_above(double a, double b) { return -product_below(-a, b); }

  // b > 0; infinite only as an upper bound that brings the result towards zero.
  static double quotient_below(double a, double b) {
    if (a == 0 || b == infinity) return 0;
    const double quotient = a / b;
    if (std::abs(quotient) == infinity) return infinite_below(quotient, a, b);
    return below(quotient, error_free::quotient_residual(a, b, quotient));
  }
  static double quotient_above(double a, double b) { return -quotient_below(-a, b); }

  static double infinite_below(double result, double a, double b) {
    if (result < 0 || std::isinf(a) || std::isinf(b)) return result;
    return std::numeric_limits<double>::max();
  }

  static bool is_root(double root, double a) {
    return std::isfinite(a) && root * root == a && (Interval(root) * Interval(root)).is_point();
  }
  static double root_below(double a) {
    if (!(a > 0)) return 0;
    if (a == infinity) return std::numeric_limits<double>::max();
    const double root = std::sqrt(a);
    return is_root(root, a) ? root : below(root, -1);
  }
  static double root_above(double a) {
    const double root = std::sqrt(a);
    return is_root(root, a) || root == infinity ? root : above(root, 1);
  }

  static Interval point_product(double a, double b) {
    if (a == 0 || b == 0) return {};
    const double product = a * b;
    if (std::abs(product) == infinity) return {product_below(a, b), product_above(a, b), Trusted{}};
    const double residual = error_free::product_residual(a, b, product);
    return {below(product, residual), above(product, residual), Trusted{}};
  }
  static Interval hull_of_corners(const Interval& a, const Interval& b) {
    return {
        std::min(std::min(product_below(a.lower_, b.lower_), product_below(a.lower_, b.upper_)),
                 std::min(product_below(a.upper_, b.lower_), product_below(a.upper_, b.upper_))),
        std::max(std::max(product_above(a.lower_, b.lower_), product_above(a.lower_, b.upper_)),
                 std::max(product_above(a.upper_, b.lower_), product_above(a.upper_, b.upper_))),
        Trusted{}};
  }
  static Interval over_positive(const Interval& a, const Interval& b) {  // b > 0
    return {quotient_below(a.lower_, a.lower_ >= 0 ? b.upper_ : b.lower_),
            quotient_above(a.upper_, a.upper_ >= 0 ? b.lower_ : b.upper_), Trusted{}};
  }

  double lower_ = 0, upper_ = 0;
};

/// The sign that all numbers of the interval share, if any. Certified.
inline std::optional<int> certified_sign(const Interval& value) {
  if (value.lower() > 0) return 1;
  if (value.upper() < 0) return -1;
  if (value.lower() == 0 && value.upper() == 0) return 0;
  return std::nullopt;
}

/// The sign as in certified_sign; throws UndecidedSign if no sign is certain.
inline int sign(const Interval& value) {
  const std::optional<int> certified = certified_sign(value);
  if (!certified) throw UndecidedSign();
  return *certified;
}

/// The middle, rounded; an infinity if one bound is infinite, NaN for the whole line.
inline double approximate(const Interval& value) {
  return value.is_point() ? value.lower() : 0.5 * value.lower() + 0.5 * value.upper();
}

}  // namespace minkref
