// Integer vectors beside their doubles, and signs that both decide.
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "reference/number/bounded_double.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref::inline space {

using BoundedVector = std::array<BoundedDouble, 3>;

template <class T>
std::array<T, 3> operator-(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
std::array<T, 3> operator+(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
std::array<T, 3> operator*(const T& factor, const std::array<T, 3>& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
template <class T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// An integer and the double beside it, times 2^-shift. Coordinates too long for doubles get a
/// shift that makes their doubles short enough; a product's shift is the sum of the factors'
/// shifts, so that all doubles behind a sign are the same coordinates on another scale.
struct FilteredInteger {
  Integer exact;
  BoundedDouble rounded;
  FilteredInteger() = default;
  FilteredInteger(Integer value, long shift) : exact(std::move(value)), rounded(exact, shift) {}
  template <class T>
  const T& as() const {
    if constexpr (std::is_same_v<T, Integer>) {
      return exact;
    } else {
      return rounded;
    }
  }
};

struct FilteredVector {
  IntegerVector exact;
  BoundedVector rounded;
  FilteredVector() = default;
  FilteredVector(IntegerVector vector, long shift)
      : exact(std::move(vector)),
        rounded{BoundedDouble(exact[0], shift), BoundedDouble(exact[1], shift),
                BoundedDouble(exact[2], shift)} {}
  template <class T>
  const std::array<T, 3>& as() const {
    if constexpr (std::is_same_v<T, Integer>) {
      return exact;
    } else {
      return rounded;
    }
  }
};

/// The point vector / weight, on the scale of a shift; weight > 0.
inline BoundedVector rounded_point(const IntegerVector& vector, const Integer& weight, long shift) {
  BoundedVector at = FilteredVector(vector, shift).rounded;
  if (weight != 1) {
    const BoundedDouble by(weight);
    for (BoundedDouble& coordinate : at) coordinate = coordinate / by;
  }
  return at;
}

/// How signs were decided.
struct SignCounts {
  std::uint64_t by_float = 0, by_integer = 0;
  void add(const SignCounts& other) {
    by_float += other.by_float;
    by_integer += other.by_integer;
  }
};

/// The sign of `evaluate` on bounded doubles or, if these do not settle the sign, on integers.
template <class Evaluate>
int filtered_sign(SignCounts& counts, Evaluate&& evaluate) {
  const int certain = evaluate(std::type_identity<BoundedDouble>{}).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++counts.by_float;
    return certain;
  }
  ++counts.by_integer;
  return sign(evaluate(std::type_identity<Integer>{}));
}

}  // namespace minkref::inline space
