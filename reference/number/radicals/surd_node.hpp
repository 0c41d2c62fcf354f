// The insides of a Surd.
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "reference/number/radicals/surd.hpp"

namespace minkref {

/// f √m, with whole m > 0 that has no small square factor.
struct SurdTerm {
  Integer inside;
  Rational factor;
};

struct Surd::Node {
  enum class Kind : std::uint8_t { terms, sum, product, quotient, root };

  Kind kind = Kind::terms;
  std::vector<SurdTerm> terms;  ///< ascending by m, no factor 0
  Ref a, b;                     ///< operands
  Interval near;

  bool is_zero() const { return kind == Kind::terms && terms.empty(); }
  bool is_rational() const {
    return kind == Kind::terms && (terms.empty() || (terms.size() == 1 && terms[0].inside == 1));
  }
};

/// Returns B such that a number nearer to 0 than 2^-B is 0.
///
/// Theorem (Burnikel, Funke, Mehlhorn, Schirra, Schmitt 2009). The number is U / L with algebraic
/// integers U and L in a common field, all conjugates at most u and l in size; the code has the
/// rules for u and l. For a field with degree D and U not 0, the product over U's conjugates is a
/// whole number, not 0: |U| >= u^(1 - D), hence |U / L| >= u^(1 - D) / l. Roots from whole numbers
/// contribute the factor 2^r, with their rank r modulo squares; every nested root doubles D.
double surd_bits(const Surd::Ref& node);

/// The value of an expression, with each shared part evaluated once.
MpfrInterval surd_value(const Surd::Ref& node, long precision);

}  // namespace minkref
