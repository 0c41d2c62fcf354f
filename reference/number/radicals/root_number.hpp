// Exact numbers with nested square roots: the fields Q(√m)(√n)(√o) of the events of a disc.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "reference/number/interval.hpp"
#include "reference/number/radicals/mpfr_interval.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

class RootNumber;

/// The rationals with roots adjoined one after the other, each the root of a number of the field
/// before. A root may belong to that field already: then numbers have several names, and signs and
/// equality are still right.
class RootField {
 public:
  static constexpr std::size_t most_roots = 4;

  static std::shared_ptr<const RootField> rationals();
  /// The radicand's field with √radicand adjoined; requires radicand >= 0. Throws LimitExceeded
  /// ("too-many-roots") beyond most_roots.
  static std::shared_ptr<const RootField> with_root_of(const RootNumber& radicand);

  std::size_t roots() const { return radicands_.size(); }
  /// The field before the last root; none of the rationals.
  const std::shared_ptr<const RootField>& base() const { return base_; }
  /// The coefficients of the adjoined roots' radicands: 2^k for the k-th.
  const std::vector<std::vector<Rational>>& radicands() const { return radicands_; }

 private:
  friend class RootNumber;
  RootField() = default;

  std::shared_ptr<const RootField> base_;  ///< none of the rationals
  std::vector<std::vector<Rational>> radicands_;
  mutable std::vector<Interval> rounded_;  ///< the roots
};

/// a + b √m with a and b of the field below, down to rationals.
class RootNumber {
 public:
  RootNumber() : RootNumber(Rational(0)) {}
  RootNumber(const Rational& value);                      // NOLINT: implicit, since it is exact
  RootNumber(int value) : RootNumber(Rational(value)) {}  // NOLINT

  /// √value, in the field of `value` if this is a rational's square, else with a root adjoined.
  friend RootNumber sqrt(const RootNumber& value);
  /// The same number as an element of a field made from its own.
  RootNumber in(const std::shared_ptr<const RootField>& field) const;

  const std::shared_ptr<const RootField>& field() const { return field_; }
  const std::vector<Rational>& coefficients() const { return coefficients_; }

  // Requires that one field was made from the other; throws std::logic_error otherwise.
  friend RootNumber operator-(const RootNumber& a);
  friend RootNumber operator+(const RootNumber& a, const RootNumber& b);
  friend RootNumber operator-(const RootNumber& a, const RootNumber& b);
  friend RootNumber operator*(const RootNumber& a, const RootNumber& b);
  /// Throws std::domain_error if the divisor is zero.
  friend RootNumber operator/(const RootNumber& a, const RootNumber& b);

  /// Exact: doubles, then MPFR, then a + b √m by the signs of a, b and a² - b² m.
  friend int sign(const RootNumber& value);
  friend bool operator==(const RootNumber& a, const RootNumber& b) { return sign(a - b) == 0; }

  /// It holds the number.
  Interval enclosure() const;
  MpfrInterval enclosure(long precision) const;

  /// Coefficients of a monic polynomial over the rationals that has the number as a root, the
  /// lowest first: the product over all signs of the roots. Degree 2^roots.
  std::vector<Rational> polynomial() const;

 private:
  RootNumber(std::shared_ptr<const RootField> field, std::vector<Rational> coefficients)
      : field_(std::move(field)), coefficients_(std::move(coefficients)) {}
  static std::shared_ptr<const RootField> common(const RootNumber& a, const RootNumber& b);

  std::shared_ptr<const RootField> field_;
  std::vector<Rational> coefficients_;  ///< of 1, √m, √n, √m √n, ...
};

RootNumber sqrt(const RootNumber& value);
RootNumber operator-(const RootNumber& a);
RootNumber operator+(const RootNumber& a, const RootNumber& b);
RootNumber operator-(const RootNumber& a, const RootNumber& b);
RootNumber operator*(const RootNumber& a, const RootNumber& b);
RootNumber operator/(const RootNumber& a, const RootNumber& b);
int sign(const RootNumber& value);

}  // namespace minkref
