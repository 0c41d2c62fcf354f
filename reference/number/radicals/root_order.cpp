#include "reference/number/radicals/root_order.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/number/radicals/polynomial.hpp"

namespace minkref {
namespace {

constexpr long first_bits = 128;

/// Whether x is a root of p.
bool is_root(const Polynomial& p, const RootNumber& x) { return sign(value_at(p, x)) == 0; }

/// Whether both are written alike, which equal numbers need not be: a quick yes, as of places that
/// are translates of each other.
bool are_written_alike(const RootNumber& a, const RootNumber& b) {
  return a.coefficients() == b.coefficients() && a.field()->radicands() == b.field()->radicands();
}

}  // namespace

int compare(const RootNumber& a, const RootNumber& b) {
  const Interval near = a.enclosure(), other = b.enclosure();
  if (near.upper() < other.lower()) return -1;
  if (near.lower() > other.upper()) return 1;
  if (are_written_alike(a, b)) return 0;
  look_for_interrupt_now();  // what follows may take a millisecond
  Polynomial common;
  bool may_be_equal = true;
  for (long bits = first_bits;; bits *= 2) {
    const MpfrInterval x = a.enclosure(bits), y = b.enclosure(bits);
    if (x.is_below(y)) return -1;
    if (y.is_below(x)) return 1;
    if (!may_be_equal) continue;
    if (common.empty()) {
      common = without_multiple_roots(common_divisor(a.polynomial(), b.polynomial()));
      may_be_equal = common.size() > 1 && is_root(common, a) && is_root(common, b);
      if (!may_be_equal) continue;
    }
    // Both are roots between these bounds. `low` counts apart, since count_roots leaves it out.
    const Rational low = std::min(x.low(), y.low()), high = std::max(x.high(), y.high());
    const bool at_low = value_at(common, low) == 0;
    if (count_roots(common, low, high) + (at_low ? 1 : 0) == 1) return 0;
  }
}

}  // namespace minkref
