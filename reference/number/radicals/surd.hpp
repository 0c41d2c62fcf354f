// Exact numbers from rational numbers by + - * / and square roots, in any order, from any fields: a
// single program text for rounded and exact numbers.
#pragma once

#include <memory>
#include <optional>

#include "reference/number/interval.hpp"
#include "reference/number/radicals/mpfr_interval.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

/// An expression. Sums and products with rational radicands are multiplied out to terms f √m, so
/// most equal numbers look equal; all remaining numbers keep their operands.
///
/// A RootNumber (root_number.hpp) needs both operands in a chain of fields. A Surd takes any
/// operands; in return, zero takes more bits to recognise.
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

  /// Exact: by doubles, then by MPFR, up to a separation bound (surd_node.hpp). Throws
  /// LimitExceeded ("too-many-roots") beyond 2^24 bits.
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
