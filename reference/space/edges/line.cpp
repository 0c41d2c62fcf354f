#include "reference/space/edges/line.hpp"

#include <algorithm>
#include <cmath>

namespace minkref::inline space {
namespace {

/// An integer of moderate size near the middle of both boxes along an axis, else 0.
int level_between(const SpaceBox& a, const SpaceBox& b, std::size_t axis) {
  const double low = std::max(a.low[axis], b.low[axis]);
  const double high = std::min(a.high[axis], b.high[axis]);
  const double middle = std::round(low / 2 + high / 2);
  return std::abs(middle) < 1e9 ? static_cast<int>(middle) : 0;
}

std::size_t widest_certain_axis(const BoundedVector& vector) {
  std::size_t axis = 0;
  double most = -SpaceBox::infinity;
  for (std::size_t k = 0; k < 3; ++k) {
    const double certain = std::abs(vector[k].value) - vector[k].error;
    if (certain > most) {
      most = certain;
      axis = k;
    }
  }
  return axis;
}

}  // namespace

CarrierLine::CarrierLine(const ConvolutionFacet& facet, std::size_t side)
    : a_(facet), b_(facet), side_(static_cast<int>(side)), rounded_(made<BoundedDouble>()) {}

CarrierLine::CarrierLine(const ConvolutionFacet& a, const ConvolutionFacet& b, long shift)
    : a_(a), b_(b), shift_(shift) {
  const BoundedVector along = cross(a.normal.rounded, b.normal.rounded);
  axis_ = widest_certain_axis(along);
  int sign = along[axis_].certain_sign();
  if (sign == BoundedDouble::undecided || sign == 0) {
    const IntegerVector exact = cross(a.normal.exact, b.normal.exact);
    axis_ = longest_axis(exact);
    sign = exact[axis_].sign();
  }
  direction_ = sign;
  level_ = level_between(a.box, b.box, axis_);
  rounded_ = made<BoundedDouble>();
}

template <class T>
LineIn<T> CarrierLine::made() const {
  if (side_ != CutterPlane::own) {
    const auto k = static_cast<std::size_t>(side_);
    const std::size_t next = (k + 1) % a_.size;
    const std::array<T, 3>&start = a_.corners[k].as<T>(), &end = a_.corners[next].as<T>();
    if (!a_.piece) return {start, end - start, T(1)};
    const T of_start = a_.weight<T>(k), of_end = a_.weight<T>(next);
    return {of_end * start, of_start * end - of_end * start, of_start * of_end};
  }
  const std::array<T, 3>&n = a_.normal.as<T>(), &m = b_.normal.as<T>();
  const std::array<T, 3> along = cross(n, m);
  const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  T level(level_);
  if constexpr (std::is_same_v<T, Integer>) level <<= static_cast<unsigned long>(shift_);
  const T c = a_.offset.as<T>() - n[axis_] * level, d = b_.offset.as<T>() - m[axis_] * level;
  LineIn<T> line;
  line.weight = along[axis_];
  line.origin[axis_] = level * along[axis_];
  line.origin[i] = c * m[j] - d * n[j];
  line.origin[j] = n[i] * d - m[i] * c;
  line.direction = along;
  if (direction_ < 0) {
    line.weight = -line.weight;
    for (std::size_t k = 0; k < 3; ++k) {
      line.origin[k] = -line.origin[k];
      line.direction[k] = -line.direction[k];
    }
  }
  return line;
}

template LineIn<BoundedDouble> CarrierLine::made<BoundedDouble>() const;
template LineIn<Integer> CarrierLine::made<Integer>() const;

bool CarrierLine::parallel(const ConvolutionFacet& a, const ConvolutionFacet& b,
                           SignCounts& signs) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const int sign = filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
      const std::array<T, 3>&n = a.normal.as<T>(), &m = b.normal.as<T>();
      return T(n[i] * m[j] - n[j] * m[i]);
    });
    if (sign != 0) return false;
  }
  return true;
}

BoundedVector CarrierLine::point_at(const BoundedDouble& t) const {
  BoundedVector point = rounded_.origin + t * rounded_.direction;
  if (rounded_.weight.value != 1 || rounded_.weight.error != 0) {
    for (BoundedDouble& coordinate : point) coordinate = coordinate / rounded_.weight;
  }
  return point;
}

int CarrierLine::slope(const ConvolutionFacet& facet, SignCounts& signs) const {
  if (&facet == &a_ || &facet == &b_) return 0;
  return filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
    return dot(facet.normal.as<T>(), as<T>().direction);
  });
}

}  // namespace minkref::inline space
