#include "reference/number/radicals/surd_of_root.hpp"

#include <vector>

namespace minkref {
namespace {

/// a + b √m from 2^level coefficients, with the values of the roots so far.
Surd value_of(const std::vector<Surd>& roots, std::size_t level, const Rational* coefficients) {
  if (level == 0) return *coefficients;
  const std::size_t half = std::size_t{1} << (level - 1);
  return value_of(roots, level - 1, coefficients) +
         value_of(roots, level - 1, coefficients + half) * roots[level - 1];
}

}  // namespace

Surd surd_of(const RootNumber& value) {
  std::vector<Surd> roots;
  for (const std::vector<Rational>& radicand : value.field()->radicands()) {
    roots.push_back(sqrt(value_of(roots, roots.size(), radicand.data())));
  }
  return value_of(roots, roots.size(), value.coefficients().data());
}

}  // namespace minkref
