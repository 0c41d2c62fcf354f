#include "reference/plane/point_predicates.hpp"

#include <cmath>
#include <limits>

namespace minkref::inline plane {
namespace {

constexpr double unit = 1.0 / 9007199254740992.0;  // 2^-53
constexpr double tiny = 1e-290;  // below it underflow may spoil a bound: not decided

/// Coordinates have errors of at most half an ulp: relative, or 2^-1075 for subnormal numbers,
/// which matters beside a partner of 2^1000.
double coordinate_error(double a, double b) {
  return unit * (std::abs(a) + std::abs(b)) + 2 * std::numeric_limits<double>::denorm_min();
}

/// The sign of u x v; components off by at most eu, ev besides the rounding of the subtraction. 0:
/// not decided.
int filtered_turn(double ux, double uy, double vx, double vy, double eu, double ev) {
  const double left = ux * vy, right = uy * vx;
  const double difference = left - right;
  const double bound = (std::abs(left) + std::abs(right)) * 8 * unit +
                       1.01 * (eu * (std::abs(vx) + std::abs(vy)) +
                               ev * (std::abs(ux) + std::abs(uy)) + 2 * eu * ev) +
                       tiny;
  return difference > bound ? 1 : difference < -bound ? -1 : 0;
}

int compare(double a, double b, const Rational& x, const Rational& y) {
  const double difference = a - b, bound = 4 * coordinate_error(a, b) + tiny;
  if (difference > bound) return 1;
  if (difference < -bound) return -1;
  return x < y ? -1 : y < x ? 1 : 0;
}

}  // namespace

int turn(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& c,
         const FilteredPoint& d) {
  const double eu = 2 * (coordinate_error(a.x(), b.x()) + coordinate_error(a.y(), b.y()));
  const double ev = 2 * (coordinate_error(c.x(), d.x()) + coordinate_error(c.y(), d.y()));
  const int filtered =
      filtered_turn(b.x() - a.x(), b.y() - a.y(), d.x() - c.x(), d.y() - c.y(), eu, ev);
  if (filtered != 0) return filtered;
  const Point &pa = a.exact(), &pb = b.exact(), &pc = c.exact(), &pd = d.exact();
  return sign(Rational((pb.x - pa.x) * (pd.y - pc.y) - (pb.y - pa.y) * (pd.x - pc.x)));
}

int orientation(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& c) {
  return turn(a, b, a, c);
}

int compare_x(const FilteredPoint& a, const FilteredPoint& b) {
  return compare(a.x(), b.x(), a.exact().x, b.exact().x);
}
int compare_y(const FilteredPoint& a, const FilteredPoint& b) {
  return compare(a.y(), b.y(), a.exact().y, b.exact().y);
}
int compare_xy(const FilteredPoint& a, const FilteredPoint& b) {
  const int x = compare_x(a, b);
  return x != 0 ? x : compare_y(a, b);
}
int compare_xy(const Point& a, const Point& b) {
  if (a.x != b.x) return a.x < b.x ? -1 : 1;
  return a.y < b.y ? -1 : b.y < a.y ? 1 : 0;
}

}  // namespace minkref::inline plane
