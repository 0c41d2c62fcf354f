#include "reference/space/critical/crossing_line.hpp"

#include <algorithm>
#include <cmath>

namespace minkref::inline space {
namespace {

std::size_t crossing_axis(const FilteredVector& n, const FilteredVector& m) {
  const BoundedVector along = cross(n.rounded, m.rounded);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(along[k].value) - along[k].error >
        std::abs(along[axis].value) - along[axis].error) {
      axis = k;
    }
  }
  const int sign = along[axis].certain_sign();
  if (sign == 1 || sign == -1) return axis;
  return longest_axis(cross(n.exact, m.exact));
}

/// Without a common factor that may be beyond doubles.
void bring_near_one(LineForm<BoundedDouble>& row) {
  const double most =
      std::max({std::abs(row.alpha.value), std::abs(row.beta.value), std::abs(row.gamma.value)});
  if (!(most > 0) || !std::isfinite(most)) return;
  const int exponent = std::ilogb(most);
  for (BoundedDouble* number : {&row.alpha, &row.beta, &row.gamma}) {
    if (number->error == 0 && number->value == 0) continue;
    number->value = std::ldexp(number->value, -exponent);
    number->error = std::ldexp(number->error, -exponent) + 1e-300;
  }
}

}  // namespace

CrossingLine::CrossingLine(const MovingConvolution& convolution, const MovingFacet& first,
                           const MovingFacet& second, SignCounts& signs)
    : convolution_(convolution),
      first_(first),
      second_(second),
      axis_(crossing_axis(first.normal, second.normal)) {
  const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  is_negative_ = filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
                   const std::array<T, 3>&n = first.normal.as<T>(), &m = second.normal.as<T>();
                   return T(n[i] * m[j] - n[j] * m[i]);
                 }) < 0;
  rounded_ = parts<BoundedDouble>();
}

template <class T>
CrossingLine::Parts<T> CrossingLine::parts() const {
  const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
  const auto &from = first_.names[0], &to = second_.names[0];
  const std::array<T, 3>&n = first_.normal.as<T>(), &m = second_.normal.as<T>();
  Parts<T> found;
  found.A = dot(m, P.points[to.of_P].as<T>() - P.points[from.of_P].as<T>());
  found.B = dot(m, Q.points[to.of_Q].as<T>() - Q.points[from.of_Q].as<T>());
  found.along = cross(n, m);
  found.foot[axis_] = T(0);
  found.foot[(axis_ + 1) % 3] = -n[(axis_ + 2) % 3];
  found.foot[(axis_ + 2) % 3] = n[(axis_ + 1) % 3];
  found.weight = found.along[axis_];
  if (is_negative_) {
    found.weight = -found.weight;
    for (std::size_t k = 0; k < 3; ++k) {
      found.along[k] = -found.along[k];
      found.foot[k] = -found.foot[k];
    }
  }
  return found;
}

template <class T>
LineForm<T> CrossingLine::form_of(const Parts<T>& parts, const std::array<T, 3>& direction,
                                  const ConvolutionFacet::Corner& corner) const {
  const SpaceOperand &P = convolution_.P, &Q = convolution_.Q;
  const auto& base = first_.names[0];
  const T lean = dot(direction, parts.foot);
  const T of_P = dot(direction, P.points[corner.of_P].as<T>() - P.points[base.of_P].as<T>()),
          of_Q = dot(direction, Q.points[corner.of_Q].as<T>() - Q.points[base.of_Q].as<T>());
  return {T(parts.A * lean - parts.weight * of_P), T(dot(direction, parts.along)),
          T(parts.B * lean - parts.weight * of_Q)};
}

LineForm<BoundedDouble> CrossingLine::form(const BoundedVector& direction,
                                           const ConvolutionFacet::Corner& corner) const {
  return form_of(rounded_, direction, corner);
}

const CrossingLine::Parts<Integer>& CrossingLine::exact() {
  if (!exact_) exact_ = parts<Integer>();
  return *exact_;
}

LineForm<Integer> CrossingLine::form(const IntegerVector& direction,
                                     const ConvolutionFacet::Corner& corner) {
  return form_of(exact(), direction, corner);
}

std::array<Rational, 3> CrossingLine::point(const Rational& s, const Rational& t) {
  const Parts<Integer>& line = exact();
  const IntegerVector &p = convolution_.P.points[first_.names[0].of_P].exact,
                      &q = convolution_.Q.points[first_.names[0].of_Q].exact;
  const Rational reach = s * Rational(line.A) + Rational(line.B);
  const auto coordinate = [&](std::size_t k) -> Rational {
    const Rational moved = reach * Rational(line.foot[k]) + t * Rational(line.along[k]);
    return s * Rational(p[k]) + Rational(q[k]) + moved / Rational(line.weight);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

ContactRow::ContactRow(CrossingLine& line, const MovingFacet& facet, std::uint8_t side)
    : line_(&line), facet_(&facet), side_(side) {
  const BoundedVector& normal = facet.normal.rounded;
  rounded_ = side == plane ? line.form(normal, facet.names[0])
                           : line.form(cross(normal, facet.along[side].rounded), facet.names[side]);
  bring_near_one(rounded_);
}

ContactRow::ContactRow(const Integer& alpha, const Integer& gamma)
    : rounded_{BoundedDouble(alpha), BoundedDouble(0), BoundedDouble(gamma)},
      exact_{{alpha, Integer(0), gamma}} {
  bring_near_one(rounded_);
}

const LineForm<Integer>& ContactRow::exact() {
  if (!exact_) {
    const IntegerVector& normal = facet_->normal.exact;
    exact_ = side_ == plane
                 ? line_->form(normal, facet_->names[0])
                 : line_->form(cross(normal, facet_->along[side_].exact), facet_->names[side_]);
  }
  return *exact_;
}

}  // namespace minkref::inline space
