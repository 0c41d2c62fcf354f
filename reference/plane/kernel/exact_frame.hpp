// The exact kernel that fits two operands' numbers: grid integers if possible, otherwise rationals.
#pragma once

#include <cmath>
#include <type_traits>

#include "reference/plane/kernel/frame.hpp"

namespace minkref::inline plane {

/// Both operands in the frame of a kernel, and the way back to real coordinates.
template <class Grid>
struct GridFrame {
  using K = GridKernel<Grid>;
  K kernel;
  Operand<typename K::Vector> P, Q;
  Integer denominator;
  static std::string name() { return Grid::name; }
  Point position(const typename K::Node& node) const {
    return grid_position<Grid>(node, denominator);
  }
};

template <class T>
struct ScalarFrame {
  using K = PlainKernel<T>;
  K kernel;
  Operand<Vector2<T>> P, Q;
  Arithmetic<T> arithmetic;
  std::string name() const { return arithmetic.name(); }
};

template <>
inline std::string ScalarFrame<Rational>::name() const {
  return "rational";
}

inline Point position(const ScalarFrame<Rational>&, const Vector2<Rational>& node) {
  return {node.x(), node.y()};
}
template <class Grid>
Point position(const GridFrame<Grid>& frame, const typename GridKernel<Grid>::Node& node) {
  return frame.position(node);
}

/// Calls use(frame) with the narrowest exact frame that holds both operands; P is already scaled.
/// Exact.
template <class Use>
auto on_exact_frame(const PolygonSet& P, const PolygonSet& Q, Use&& use) {
  const GridFit fit = grid_fit({&P, &Q}, Grid256::bits - 1);
  const auto grid = [&]<class Grid>(Grid) {
    const double magnitude = std::ldexp(1.0, static_cast<int>(fit.bits) + 1);
    GridFrame<Grid> frame{GridKernel<Grid>(magnitude), grid_operand<Grid>(P, fit.denominator),
                          grid_operand<Grid>(Q, fit.denominator), fit.denominator};
    return use(frame);
  };
  if (fit.bits < Grid64::bits) return grid(Grid64{});
  if (fit.bits < Grid256::bits) return grid(Grid256{});
  ScalarFrame<Rational> frame{
      {}, scalar_operand<Rational>(P, {}), scalar_operand<Rational>(Q, {}), {}};
  return use(frame);
}

}  // namespace minkref::inline plane
