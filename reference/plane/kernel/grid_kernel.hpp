// The exact kernel on an integer grid: after a common denominator every convolution vertex is a
// pair of integers. A float filter with a proven bound decides most signs, integers of fixed width
// the rest.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "reference/number/int128.hpp"
#include "reference/number/rational.hpp"
#include "reference/plane/kernel/kernel.hpp"

namespace minkref::inline plane {

/// The grid's integers: Int for coordinates, Wide for products of two, Huge for products of four.
struct Grid64 {
  using Int = std::int64_t;
  using Wide = Int128;
  using Huge = boost::multiprecision::int256_t;
  static constexpr int bits = 60;  ///< most bits of a coordinate, sums and differences included
  static constexpr const char* name = "grid64";
};

template <unsigned Bits>
using FixedInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<Bits, Bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

struct Grid256 {
  using Int = FixedInteger<256>;
  using Wide = FixedInteger<512>;
  using Huge = FixedInteger<1024>;
  static constexpr int bits = 250;
  static constexpr const char* name = "grid256";
};

template <class Int>
int sign_of(const Int& value) {
  return (value > 0) - (value < 0);
}

inline double grid_double(std::int64_t value) { return static_cast<double>(value); }
inline double grid_double(Int128 value) { return static_cast<double>(value); }
template <unsigned Bits>
double grid_double(const FixedInteger<Bits>& value) {
  return value.template convert_to<double>();
}
inline Integer grid_integer(std::int64_t value) { return Integer(value); }
inline Integer grid_integer(Int128 value) { return to_integer(value); }
template <unsigned Bits>
Integer grid_integer(const FixedInteger<Bits>& value) {
  return Integer(value);
}

template <class Int>
using GridVector = Eigen::Matrix<Int, 2, 1>;

/// Relative error, in units of the input magnitudes, beyond which a double is trusted. Each
/// conversion has an error of at most 2^-51, each product and difference 2^-53 more, altogether
/// 11 * 2^-53; the bound takes 16 * 2^-53.
inline constexpr double filter_bound = 16.0 / 9007199254740992.0;

template <class Grid>
class GridKernel {
 public:
  using Coordinate = typename Grid::Int;
  using Wide = typename Grid::Wide;
  using Huge = typename Grid::Huge;
  using Vector = GridVector<Coordinate>;

  /// t = num / den, den > 0; `value` has a relative error of at most 9 * 2^-53.
  struct Parameter {
    double value = 0;
    Wide num = 0, den = 1;
  };
  /// A vertex (direction zero), or start + t * direction; x and y are off by at most `node_error`.
  struct Node {
    double x = 0, y = 0;
    Vector start = Vector(Coordinate(0), Coordinate(0));
    Vector direction = Vector(Coordinate(0), Coordinate(0));
    Parameter t;
  };
  /// Doubles taken as exact numbers.
  struct Query {
    double x = 0, y = 0;
  };

  /// `magnitude`: a bound on the absolute value of every vertex coordinate.
  explicit GridKernel(double magnitude = 0) : node_error(16 * filter_bound * (magnitude + 1)) {}

  int sign(const Coordinate& value) const { return sign_of(value); }
  int sign(const Wide& value) const { return sign_of(value); }
  int compare(const Coordinate& a, const Coordinate& b) const { return (a > b) - (a < b); }

  int turn(const Vector& u, const Vector& v) const {
    const double left = grid_double(u.x()) * grid_double(v.y());
    const double right = grid_double(u.y()) * grid_double(v.x());
    const double difference = left - right;
    const double bound = (std::abs(left) + std::abs(right)) * filter_bound;
    if (difference > bound) return ++counts.by_float, 1;
    if (difference < -bound) return ++counts.by_float, -1;
    ++counts.by_integer;
    return sign_of(cross(u, v));
  }

  static Wide cross(const Vector& u, const Vector& v) {
    return Wide(u.x()) * Wide(v.y()) - Wide(u.y()) * Wide(v.x());
  }

  static Wide dot(const Vector& u, const Vector& v) {
    return Wide(u.x()) * Wide(v.x()) + Wide(u.y()) * Wide(v.y());
  }

  Parameter intersection(const Vector& w, const Vector& d, const Vector& e) const {
    return parameter(cross(w, e), cross(d, e));
  }
  Parameter projection(const Vector& w, const Vector& d) const {
    return d.x() != 0 ? parameter(Wide(w.x()), Wide(d.x())) : parameter(Wide(w.y()), Wide(d.y()));
  }
  static Parameter parameter(Wide num, Wide den) {
    if (den < 0) num = -num, den = -den;
    return {grid_double(num) / grid_double(den), num, den};
  }

  int compare(const Parameter& a, const Parameter& b) const {
    const double difference = a.value - b.value;
    const double bound = (std::abs(a.value) + std::abs(b.value)) * filter_bound;
    if (difference > bound) return ++counts.by_float, 1;
    if (difference < -bound) return ++counts.by_float, -1;
    ++counts.by_integer;
    return sign_of(Huge(Huge(a.num) * Huge(b.den) - Huge(b.num) * Huge(a.den)));
  }

  static double approximation(const Parameter& t) { return t.value; }
  static Rational exact(const Parameter& t) {
    return Rational(grid_integer(t.num), grid_integer(t.den));
  }

  /// The sign of slope * t + value.
  int sign_of_linear(const Wide& slope, const Wide& value, const Parameter& t) const {
    const double product = grid_double(slope) * t.value, constant = grid_double(value);
    const double sum = product + constant;
    const double bound = (std::abs(product) + std::abs(constant)) * filter_bound;
    if (sum > bound) return ++counts.by_float, 1;
    if (sum < -bound) return ++counts.by_float, -1;
    ++counts.by_integer;
    return sign_of(Huge(Huge(slope) * Huge(t.num) + Huge(value) * Huge(t.den)));
  }

  Node node(const Vector& vertex) const {
    Node node;
    node.x = grid_double(vertex.x());
    node.y = grid_double(vertex.y());
    node.start = vertex;
    return node;
  }
  Node node(const Vector& start, const Vector& d, const Parameter& t) const {
    Node node;
    node.x = grid_double(start.x()) + t.value * grid_double(d.x());
    node.y = grid_double(start.y()) + t.value * grid_double(d.y());
    node.start = start;
    node.direction = d;
    node.t = t;
    return node;
  }

  int compare_x(const Node& a, const Node& b) const { return compare_axis(a, b, a.x - b.x, 0); }
  int compare_y(const Node& a, const Node& b) const { return compare_axis(a, b, a.y - b.y, 1); }

  int orientation(const Node& a, const Node& b, const Node& c) const {
    const int filtered = filtered_turn(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y, 2 * node_error);
    if (filtered != 0) return ++counts.by_float, filtered;
    ++counts.by_rational;
    const Rational ax = exact(a, 0), ay = exact(a, 1);
    return minkref::sign(Rational((exact(b, 0) - ax) * (exact(c, 1) - ay) -
                                  (exact(b, 1) - ay) * (exact(c, 0) - ax)));
  }

  /// A node's exact coordinate (axis 0: x, 1: y).
  static Rational exact(const Node& node, int axis) {
    const Integer start = grid_integer(node.start[axis]);
    if (node.direction.x() == 0 && node.direction.y() == 0) return Rational(start);
    const Integer den = grid_integer(node.t.den);
    return Rational(
        Integer(start * den + grid_integer(node.t.num) * grid_integer(node.direction[axis])), den);
  }

  int side(const Vector& a, const Vector& d, const Query& x) const {
    const double ax = grid_double(a.x()), ay = grid_double(a.y());
    const double error = filter_bound * (std::abs(ax) + std::abs(ay));
    const int filtered =
        filtered_turn(grid_double(d.x()), grid_double(d.y()), x.x - ax, x.y - ay, error);
    if (filtered != 0) return ++counts.by_float, filtered;
    ++counts.by_rational;
    const Rational wx = from_double(x.x) - Rational(grid_integer(a.x()));
    const Rational wy = from_double(x.y) - Rational(grid_integer(a.y()));
    return minkref::sign(
        Rational(Rational(grid_integer(d.x())) * wy - Rational(grid_integer(d.y())) * wx));
  }

  Box box(const Vector& a, const Vector& b) const {
    const double ax = grid_double(a.x()), ay = grid_double(a.y());
    const double bx = grid_double(b.x()), by = grid_double(b.y());
    const double pad = filter_bound * (std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by));
    return {std::min(ax, bx) - pad, std::min(ay, by) - pad, std::max(ax, bx) + pad,
            std::max(ay, by) + pad};
  }

  Box box(const Node& n) const {
    return {n.x - node_error, n.y - node_error, n.x + node_error, n.y + node_error};
  }
  Box box(const Query& x) const { return {x.x, x.y, x.x, x.y}; }

  double node_error;
  mutable SignCounts counts;

 private:
  /// The sign of u x v if each component of u and v has at most `error` besides rounding; 0:
  /// undecided.
  static int filtered_turn(double ux, double uy, double vx, double vy, double error) {
    const double left = ux * vy, right = uy * vx;
    const double difference = left - right;
    const double bound = (std::abs(left) + std::abs(right)) * filter_bound +
                         2 * error * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy)) +
                         4 * error * error;
    return difference > bound ? 1 : difference < -bound ? -1 : 0;
  }

  int compare_axis(const Node& a, const Node& b, double difference, int axis) const {
    if (difference > 2 * node_error) return ++counts.by_float, 1;
    if (difference < -2 * node_error) return ++counts.by_float, -1;
    if (a.direction.x() == 0 && a.direction.y() == 0 && b.direction.x() == 0 &&
        b.direction.y() == 0) {
      ++counts.by_integer;
      return compare(a.start[axis], b.start[axis]);
    }
    ++counts.by_rational;
    return minkref::sign(Rational(exact(a, axis) - exact(b, axis)));
  }
};

}  // namespace minkref::inline plane
