// Doubles on trial: each operation of intervals and bounded doubles, the error-free transforms and
// the float filters, against rationals. Headers only, to be compiled with anybody's flags.
#pragma once

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <string>

#include "reference/number/interval.hpp"
#include "reference/paper/trials/float_numbers.hpp"

namespace minkref::float_trial {

/// How often each thing was tried, and how often it was wrong.
class Counts {
 public:
  void add(const char* what, bool right) {
    Count& count = all_[what];
    ++count.tried;
    count.wrong += right ? 0 : 1;
  }
  struct Count {
    std::uint64_t tried = 0, wrong = 0;
  };
  const std::map<std::string, Count>& all() const { return all_; }
  std::uint64_t wrong() const {
    std::uint64_t sum = 0;
    for (const auto& [what, count] : all_) sum += count.wrong;
    return sum;
  }

 private:
  std::map<std::string, Count> all_;
};

inline int sign_of(const Rational& value) { return value.sign(); }

/// Whether `bound` is the greatest double not above the exact number; -infinity below all.
inline bool is_tight_below(double bound, const Rational& exact) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double next = std::nextafter(bound, infinity);
  if (std::isinf(bound) ? bound > 0 : from_double(bound) > exact) return false;
  return std::isinf(next) || from_double(next) > exact;
}
inline bool is_tight_above(double bound, const Rational& exact) {
  return is_tight_below(-bound, Rational(-exact));
}

/// A result between the least and the greatest exact one, and tight.
inline void judge(Counts& counts, const char* what, const Interval& found, const Rational& least,
                  const Rational& greatest) {
  counts.add(what, is_tight_below(found.lower(), least) && is_tight_above(found.upper(), greatest));
  const auto certain = certified_sign(found);
  counts.add("certified sign",
             !certain || (sign_of(least) == *certain && sign_of(greatest) == *certain));
}

inline void try_intervals(Numbers& numbers, Counts& counts) {
  const auto interval = [&](double a, double b) { return a < b ? Interval(a, b) : Interval(b, a); };
  const double a = numbers.finite(), c = numbers.finite();
  const double b = numbers.coin() ? a : numbers.near(a), d = numbers.coin() ? c : numbers.near(c);
  const Interval x = interval(a, b), y = interval(c, d);
  const Rational x0 = from_double(x.lower()), x1 = from_double(x.upper()),
                 y0 = from_double(y.lower()), y1 = from_double(y.upper());
  judge(counts, "interval sum", x + y, x0 + y0, x1 + y1);
  judge(counts, "interval difference", x - y, x0 - y1, x1 - y0);
  const auto extremes = [&](const char* what, const Interval& found, const Rational& p,
                            const Rational& q, const Rational& r, const Rational& s) {
    judge(counts, what, found, std::min(std::min(p, q), std::min(r, s)),
          std::max(std::max(p, q), std::max(r, s)));
  };
  extremes("interval product", x * y, x0 * y0, x0 * y1, x1 * y0, x1 * y1);
  if (!y.contains_zero()) {
    extremes("interval quotient", x / y, x0 / y0, x0 / y1, x1 / y0, x1 / y1);
  }
  if (x.lower() < 0) return;
  const Interval root = sqrt(x);
  const Rational low = from_double(root.lower()), high = from_double(root.upper());
  const double beside = 2 * 0x1p-52;
  counts.add("interval square root",
             low * low <= x0 && high * high >= x1 &&
                 (x0 != x1 || root.upper() - root.lower() <= beside * root.upper()));
}

inline void try_conversions(Numbers& numbers, Counts& counts) {
  const Rational exact = from_double(numbers.finite()) / from_double(numbers.not_zero());
  judge(counts, "interval of a rational", Interval(exact), exact, exact);
  const double nearest = to_double(exact);
  if (std::isinf(nearest)) return;
  const Rational off = abs(Rational(from_double(nearest) - exact));
  const auto is_nearer = [&](double other) {
    return !std::isinf(other) && abs(Rational(from_double(other) - exact)) < off;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  counts.add("nearest double", !is_nearer(std::nextafter(nearest, infinity)) &&
                                   !is_nearer(std::nextafter(nearest, -infinity)));
}

inline void try_residuals(Numbers& numbers, Counts& counts) {
  const double a = numbers.not_zero(), b = numbers.coin() ? numbers.not_zero() : -numbers.near(a);
  const Rational x = from_double(a), y = from_double(b);
  const auto signs_agree = [](double residual, const Rational& exact) {
    return (residual > 0) - (residual < 0) == sign_of(exact);
  };
  if (const double sum = a + b; std::isfinite(sum)) {
    const double residual = error_free::sum_residual(a, b, sum);
    counts.add("sum residual", signs_agree(residual, x + y - from_double(sum)));
  }
  if (const double product = a * b; std::isfinite(product) && b != 0) {
    const double residual = error_free::product_residual(a, b, product);
    counts.add("product residual", signs_agree(residual, x * y - from_double(product)));
  }
  if (b == 0) return;
  if (const double quotient = a / b; std::isfinite(quotient)) {
    const double residual = error_free::quotient_residual(a, b, quotient);
    counts.add("quotient residual", signs_agree(residual, x / y - from_double(quotient)));
  }
}

}  // namespace minkref::float_trial
