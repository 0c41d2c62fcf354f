// Predicates on points s p + q, as polynomials in s.
#pragma once

#include <set>

#include "oracle/checker/reading.hpp"

namespace minkref::checker {

/// Returns the signs of a predicate's coefficients between two scales, or at one scale
/// (docs/certificates.md, "sign").
std::set<int> signs_of(const Value& predicate, const Operand& P, const Operand& Q,
                       const mpq_class& from, const mpq_class& to);

}  // namespace minkref::checker
