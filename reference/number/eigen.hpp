// Small vectors and matrices over the scalars: Eigen.
//
// No tolerance is offered: epsilon and dummy_precision are zero, so that Eigen's "fuzzy"
// comparisons are exact. Use sums, products, dot, cross, determinant; nothing that takes a root.
#pragma once

#include <Eigen/Core>

#include "reference/number/scalar.hpp"

namespace minkref {

template <class T>
struct ExactNumTraits : Eigen::GenericNumTraits<T> {
  using Real = T;
  using NonInteger = T;
  using Nested = T;
  using Literal = T;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 10,
    MulCost = 10,
  };
  static Real epsilon() { return T(0); }
  static Real dummy_precision() { return T(0); }
  static int digits10() { return 0; }
};

template <Scalar T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
template <Scalar T>
using Matrix2 = Eigen::Matrix<T, 2, 2>;

}  // namespace minkref

template <>
struct Eigen::NumTraits<minkref::Rational> : minkref::ExactNumTraits<minkref::Rational> {};
template <>
struct Eigen::NumTraits<minkref::Interval> : minkref::ExactNumTraits<minkref::Interval> {};
template <>
struct Eigen::NumTraits<minkref::Mpfr> : minkref::ExactNumTraits<minkref::Mpfr> {};
