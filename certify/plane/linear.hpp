// Exact numbers, each with a double that decides most signs.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::certify {

/// `approximate` has a relative error of at most 2^-52.
struct Value {
  Rational exact;
  double approximate = 0;
  Value() = default;
  explicit Value(Rational value) : exact(std::move(value)), approximate(to_double(exact)) {}
};

/// A corner of cells, or a vertex.
struct Place {
  Point point;
  double x = 0, y = 0;
  Place() = default;
  explicit Place(Point p) : point(std::move(p)), x(to_double(point.x)), y(to_double(point.y)) {}
};

/// A direction in lowest terms.
struct Normal {
  Integer x, y;
  double dx = 0, dy = 0;
};

inline Rational dot(const Normal& n, const Point& p) {
  return Rational(n.x) * p.x + Rational(n.y) * p.y;
}

/// The sign of n * p - h. Exact.
inline int side(const Normal& n, const Place& p, const Value& h) {
  const double left = n.dx * p.x, right = n.dy * p.y;
  const double value = left + right - h.approximate;
  const double bound =
      (std::abs(left) + std::abs(right) + std::abs(h.approximate)) * 0x1p-49 + 1e-290;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sign(Rational(dot(n, p.point) - h.exact));
}

/// All normals that came up, each once.
class NormalTable {
 public:
  /// Adds the normal in the direction (x, y), not zero, if new. Returns the normal's number.
  std::uint32_t add(const Rational& x, const Rational& y);
  const Normal& operator[](std::uint32_t id) const { return normals_[id]; }

 private:
  std::map<std::pair<Integer, Integer>, std::uint32_t> ids_;
  std::vector<Normal> normals_;
};

}  // namespace minkref::certify
