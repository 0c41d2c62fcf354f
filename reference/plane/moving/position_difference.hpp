// The exact difference of two positions along an edge, with a sufficient type.
#pragma once

#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "reference/plane/moving/edge_nodes.hpp"

namespace minkref::inline plane {

namespace detail {
template <class K>
struct WideProduct {
  using Type = typename K::Wide;
};
template <class Grid>
struct WideProduct<GridKernel<Grid>> {
  using Type = typename Grid::Huge;
};
}  // namespace detail

/// Holds products of two wide numbers of a kernel, and their differences.
template <class K>
using WideProduct = typename detail::WideProduct<K>::Type;

/// num / den as a double, with a relative error of at most 2^-51; den > 0.
inline double wide_quotient(const Rational& num, const Rational& den) {
  return to_double(Rational(num / den));
}
template <class Wide>
double wide_quotient(const Wide& num, const Wide& den) {
  return grid_double(num) / grid_double(den);
}
inline int wide_sign(const Rational& value) { return sign(value); }
template <class Wide>
int wide_sign(const Wide& value) {
  return sign_of(value);
}

/// slope s + value has the sign of x - y.
template <class K>
struct PositionDifference {
  WideProduct<K> slope, value;
};

template <class K>
PositionDifference<K> position_difference(const PositionAlong<typename K::Wide>& x,
                                          const PositionAlong<typename K::Wide>& y) {
  using Product = WideProduct<K>;
  return {Product(x.slope) * Product(y.den) - Product(y.slope) * Product(x.den),
          Product(x.value) * Product(y.den) - Product(y.value) * Product(x.den)};
}

}  // namespace minkref::inline plane
