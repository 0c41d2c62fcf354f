// Numbers with square roots as expressions.
#pragma once

#include <map>
#include <string>

#include "reference/number/radicals/root_number.hpp"

namespace minkref {

/// A sum of rational multiples of products of roots, for numbers of any fields. A product joins its
/// roots of rational numbers to one, without square factors below 1000^2. Equal sums may still look
/// different.
class RootTerms {
 public:
  /// Adds value · factor · √square, square > 0.
  void add(const RootNumber& value, const Rational& factor = 1, const Rational& square = 1);

  /// Factors, none zero, by products such as `sqrt(2)*sqrt(3 + sqrt(5))`; the product 1 is the
  /// empty text.
  const std::map<std::string, Rational>& terms() const { return terms_; }
  /// `1/2 - 3/4*sqrt(5)`, the rational term first.
  std::string text() const;

 private:
  std::map<std::string, Rational> terms_;
};

/// Exact: rational numbers, `+`, `-`, `*` and `sqrt(...)`.
std::string expression(const RootNumber& value);

}  // namespace minkref
