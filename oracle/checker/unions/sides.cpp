#include "oracle/checker/unions/sides.hpp"

namespace minkref::checker {
namespace {

/// Sign of a + e b for small e > 0.
int sign_beside(const mpq_class& a, const mpq_class& b) { return sgn(a) != 0 ? sgn(a) : sgn(b); }

bool is_above(const Point& v, const Point& p, const Point& beside) {
  return sign_beside(v.y - p.y, -beside.y) > 0;
}

}  // namespace

Sides sides_of(const Operand& set) {
  require(!set.thin, set.name + " is a point or a segment");
  Sides found;
  for (const auto& ring : set.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      found.push_back({set.exact[ring[i]], set.exact[ring[(i + 1) % ring.size()]]});
      require(found.back().from != found.back().to, set.name + " has an edge of length zero");
    }
  }
  return found;
}

long winding(const Sides& sides, const Point& p, const Point& beside) {
  long turns = 0;
  for (const auto& [a, b] : sides) {
    const bool first = is_above(a, p, beside), second = is_above(b, p, beside);
    if (first == second) continue;
    const Point u = minus(b, a);
    const bool left = sign_beside(cross(u, minus(p, a)), cross(u, beside)) > 0;
    if (second && left) ++turns;
    if (first && !left) --turns;
  }
  return turns;
}

std::vector<mpq_class> cuts(const Side& side, const Side& other) {
  const Point u = minus(side.to, side.from), v = minus(other.to, other.from),
              w = minus(other.from, side.from);
  const mpq_class area = cross(u, v);
  if (area != 0) {
    const mpq_class t = cross(w, v) / area, s = cross(w, u) / area;
    if (t < 0 || t > 1 || s < 0 || s > 1) return {};
    return {t};
  }
  std::vector<mpq_class> found;
  if (cross(u, w) != 0) return found;
  for (const Point& end : {other.from, other.to}) {
    const mpq_class t = dot(u, minus(end, side.from)) / dot(u, u);
    if (t >= 0 && t <= 1) found.push_back(t);
  }
  return found;
}

bool is_inside(const Side& side, const Point& p) {
  const Point u = minus(side.to, side.from), w = minus(p, side.from);
  const mpq_class along = dot(u, w);
  return cross(u, w) == 0 && along > 0 && along < dot(u, u);
}

}  // namespace minkref::checker
