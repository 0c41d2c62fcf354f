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

/// The least bits B such that the number is 0 if it is nearer to 0 than 2^-B.
///
/// Theorem (Burnikel, Funke, Mehlhorn, Schirra, Schmitt 2009). The number is U / L for two
/// algebraic integers of one field. u bounds all conjugates of U, l those of L; the rules for both
/// are in the code. If the field's degree is D and U is not 0, then the product of U's conjugates
/// is a whole number other than 0, so |U| >= u^(1 - D), and the number is at least u^(1 - D) / l.
/// Roots of whole numbers give 2^r to the degree, where r is the rank of the numbers modulo
/// squares; each other root doubles it.
double surd_bits(const Surd::Ref& node);

/// The value of an expression, with each shared part evaluated once.
MpfrInterval surd_value(const Surd::Ref& node, long precision);

}  // namespace minkref
