// Numbers with two square roots, one inside the other, and their signs.
#pragma once

#include <gmpxx.h>

#include <memory>
#include <utility>

#include "oracle/checker/reading.hpp"

namespace minkref::checker {

/// The roots a = √first and b = √(base + part a). Both take positive numbers.
struct RootField {
  mpq_class first, base, part;
};

/// p[0] + p[1] a + p[2] b + p[3] a b; rational without a field. Exact. Numbers of two fields do not
/// mix.
class Root {
 public:
  Root() = default;
  Root(mpq_class p) : p_{std::move(p), 0, 0, 0} {}  // NOLINT: rational numbers are roots
  Root(int p) : Root(mpq_class(p)) {}               // NOLINT
  Root(std::shared_ptr<const RootField> field, mpq_class p, mpq_class q, mpq_class r, mpq_class s)
      : field_(std::move(field)), p_{std::move(p), std::move(q), std::move(r), std::move(s)} {}

  friend Root operator+(const Root& x, const Root& y);
  friend Root operator-(const Root& x, const Root& y);
  friend Root operator*(const Root& x, const Root& y);
  friend int sign(const Root& x);

 private:
  std::shared_ptr<const RootField> field_;
  mpq_class p_[4];
};

struct RootPoint {
  Root x, y;
  RootPoint(Root p, Root q) : x(std::move(p)), y(std::move(q)) {}
  RootPoint(const Point& p) : x(p.x), y(p.y) {}  // NOLINT: rational points are such points
};

inline RootPoint minus(const RootPoint& p, const RootPoint& q) { return {p.x - q.x, p.y - q.y}; }
inline Root dot(const RootPoint& u, const RootPoint& v) { return u.x * v.x + u.y * v.y; }
inline Root cross(const RootPoint& u, const RootPoint& v) { return u.x * v.y - u.y * v.x; }

}  // namespace minkref::checker
