// A common frame for both operands: the kernel that fits their numbers, and their coordinates.
#pragma once

#include <optional>

#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/operand.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

/// The common denominator of some points, and the bits needed.
struct GridFit {
  Integer denominator = 1;  ///< frame coordinates are real coordinates times this
  std::size_t bits = 0;     ///< of the largest frame coordinate
};

/// The least common denominator, given up (bits = SIZE_MAX) once it exceeds `limit` bits. Exact.
GridFit grid_fit(const std::vector<const PolygonSet*>& sets, std::size_t limit);

template <class Grid>
typename Grid::Int to_grid(const Rational& value, const Integer& denominator) {
  const Integer scaled =
      numerator(value) * (denominator / boost::multiprecision::denominator(value));
  if constexpr (std::is_same_v<typename Grid::Int, std::int64_t>) {
    return scaled.template convert_to<std::int64_t>();
  } else {
    return typename Grid::Int(scaled);
  }
}

template <class Grid>
Operand<typename GridKernel<Grid>::Vector> grid_operand(const PolygonSet& set,
                                                        const Integer& denominator) {
  using V = typename GridKernel<Grid>::Vector;
  return operand<V>(set, [&](const Point& p) {
    return V(to_grid<Grid>(p.x, denominator), to_grid<Grid>(p.y, denominator));
  });
}

template <class T>
Operand<Vector2<T>> scalar_operand(const PolygonSet& set, const Arithmetic<T>& arithmetic) {
  return operand<Vector2<T>>(
      set, [&](const Point& p) { return Vector2<T>(arithmetic(p.x), arithmetic(p.y)); });
}

/// A grid node's exact position with real coordinates.
template <class Grid>
Point grid_position(const typename GridKernel<Grid>::Node& node, const Integer& denominator) {
  const Rational unit = Rational(Integer(1), denominator);
  return {GridKernel<Grid>::exact(node, 0) * unit, GridKernel<Grid>::exact(node, 1) * unit};
}

}  // namespace minkref::inline plane
