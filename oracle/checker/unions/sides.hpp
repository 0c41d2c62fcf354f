// Edges of sets in the plane, and how often they wind around a point.
#pragma once

#include <vector>

#include "oracle/checker/reading.hpp"

namespace minkref::checker {

/// An edge, from its first vertex to its second.
struct Side {
  Point from, to;
};
using Sides = std::vector<Side>;

inline Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
inline mpq_class cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }
inline mpq_class dot(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y; }

/// Returns the edges of a set. Throws NotVerified for a point or a segment, and for an edge of
/// length zero.
Sides sides_of(const Operand& set);

/// Counts how often edges wind around the point p + e `beside`, which lies on none, for small e >
/// 0.
long winding(const Sides& sides, const Point& p, const Point& beside);

/// Returns where another edge meets an edge: at from + t (to - from). Common stretches give the
/// other's ends.
std::vector<mpq_class> cuts(const Side& side, const Side& other);

/// Whether a point lies on an edge, and is neither end.
bool is_inside(const Side& side, const Point& p);

}  // namespace minkref::checker
