// The plane's demands on a kernel: exact or honest signs, and nothing else.
//
// A kernel K has, besides its types,
//   Coordinate, Vector        coordinates of convolution vertices and their differences
//   Parameter                 a position along an edge, t = A/C in [0, 1]
//   Node                      a point of an arrangement (a vertex, or start + t * direction)
//   Query                     a point in general position, where collision detection is asked
// these functions:
//   compare(Coordinate, Coordinate), sign(Coordinate), turn(Vector u, Vector v)   the sign of u x v
//   intersection(w, d, e)     the t with start_d + t d on the line start_e + r e,
//                             w = start_e - start_d
//   projection(w, d)          the t with start_d + t d = start_d + w (w is parallel to d)
//   compare(Parameter, Parameter)
//   node(Vector), node(start, d, t), compare_x, compare_y, orientation(Node, Node, Node)
//   box(Vector, Vector), box(Node), box(Query)   doubles that certainly enclose the points
//   side(Vector a, Vector d, Query x)   the sign of d x (x - a)
// All signs are exact for GridKernel and PlainKernel<Rational>; PlainKernel<Interval> throws
// UndecidedSign; PlainKernel<double> and PlainKernel<Mpfr> answer as their arithmetic does.
#pragma once

#include <concepts>
#include <cstdint>

#include "reference/plane/kernel/box.hpp"

namespace minkref::inline plane {

/// How many signs each tier decided.
struct SignCounts {
  std::uint64_t by_float = 0, by_integer = 0, by_rational = 0;
};

template <class K>
concept Kernel =
    requires(K k, const typename K::Coordinate c, const typename K::Vector v,
             const typename K::Parameter t, const typename K::Node n, const typename K::Query q) {
      { k.compare(c, c) } -> std::same_as<int>;
      { k.sign(c) } -> std::same_as<int>;
      { k.turn(v, v) } -> std::same_as<int>;
      { k.intersection(v, v, v) } -> std::same_as<typename K::Parameter>;
      { k.projection(v, v) } -> std::same_as<typename K::Parameter>;
      { k.compare(t, t) } -> std::same_as<int>;
      { k.node(v) } -> std::same_as<typename K::Node>;
      { k.node(v, v, t) } -> std::same_as<typename K::Node>;
      { k.compare_x(n, n) } -> std::same_as<int>;
      { k.compare_y(n, n) } -> std::same_as<int>;
      { k.orientation(n, n, n) } -> std::same_as<int>;
      { k.box(v, v) } -> std::same_as<Box>;
      { k.box(n) } -> std::same_as<Box>;
      { k.box(q) } -> std::same_as<Box>;
      { k.side(v, v, q) } -> std::same_as<int>;
    };

}  // namespace minkref::inline plane
