// Exact numbers made of rational numbers by + - * / and square roots, in any order and of any
// fields: one program text for rounded and for exact numbers.
#pragma once

#include <memory>
#include <optional>

#include "reference/number/interval.hpp"
#include "reference/number/radicals/mpfr_interval.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

/// An expression. Sums and products of roots of rational numbers are multiplied out and kept as
/// terms f √m, so that most equal numbers look equal; other numbers keep their operands.
///
/// A RootNumber (root_number.hpp) lives in one chain of fields and needs both operands there; a
/// Surd takes any operands, and pays with a wider search where a number is 0.
class Surd {
 public:
  Surd() : Surd(Rational(0)) {}
  Surd(int value) : Surd(Rational(value)) {}  // NOLINT: implicit, since it is exact
  Surd(const Rational& value);                // NOLINT

  /// Throws std::domain_error for a negative number.
  friend Surd sqrt(const Surd& a);
  friend Surd operator-(const Surd& a);
  friend Surd operator+(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a, const Surd& b) { return a + -b; }
  friend Surd operator*(const Surd& a, const Surd& b);
  /// Throws std::domain_error where the divisor is plainly zero.
  friend Surd operator/(const Surd& a, const Surd& b);
  Surd& operator+=(const Surd& b) { return *this = *this + b; }
  Surd& operator-=(const Surd& b) { return *this = *this - b; }
  Surd& operator*=(const Surd& b) { return *this = *this * b; }
  Surd& operator/=(const Surd& b) { return *this = *this / b; }

  /// Exact: by doubles, then by MPFR, with as many bits as tell the number from 0 if it is not 0
  /// (surd_bound.hpp). Throws LimitExceeded ("too-many-roots") beyond 2^24 bits.
  friend int sign(const Surd& a);

  /// It holds the number.
  Interval enclosure() const;
  MpfrInterval enclosure(long precision) const;
  /// The number, if it is rational and has no roots left.
  std::optional<Rational> rational() const;

  struct Node;
  using Ref = std::shared_ptr<const Node>;

 private:
  explicit Surd(Ref node) : node_(std::move(node)) {}
  static Ref sum(const Ref& a, const Ref& b);
  static Ref product(const Ref& a, const Ref& b);
  static Ref quotient(const Ref& a, const Ref& b);

  Ref node_;
};

Surd sqrt(const Surd& a);
Surd operator-(const Surd& a);
Surd operator+(const Surd& a, const Surd& b);
Surd operator*(const Surd& a, const Surd& b);
Surd operator/(const Surd& a, const Surd& b);
int sign(const Surd& a);

inline double approximate(const Surd& a) { return approximate(a.enclosure()); }

}  // namespace minkref
