#include "reference/plane/convex/convex_ring.hpp"

#include <algorithm>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

Point difference(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }

int turn(const Point& u, const Point& v) { return sign(Rational(u.x * v.y - u.y * v.x)); }

bool is_less(const Point& a, const Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

Ring without_straight_vertices(const Ring& ring) {
  Ring corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    look_for_interrupt();
    const Point& before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Point& after = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (turn(difference(ring[i], before), difference(after, ring[i])) != 0)
      corners.push_back(ring[i]);
  }
  return corners;
}

/// An empty ring unless the operand is convex. A simple ring is convex iff no vertex turns right.
ConvexRing ring_if_convex(const PolygonSet& set) {
  ConvexRing found;
  if (set.polygons.size() != 1 || !set.is_region() || !set.polygons[0].holes.empty()) return {};
  found.vertices = without_straight_vertices(set.polygons[0].outer);
  std::rotate(found.vertices.begin(),
              std::min_element(found.vertices.begin(), found.vertices.end(), is_less),
              found.vertices.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    found.directions.push_back(difference(found.vertices[found.next(i)], found.vertices[i]));
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (turn(found.directions[found.before(i)], found.directions[i]) <= 0) return {};
  }
  return found;
}

}  // namespace

ConvexRing convex_ring(const PolygonSet& set, const std::string& name) {
  ConvexRing found = ring_if_convex(set);
  if (found.size() == 0) {
    throw BadInput("not-convex", name + " is not a convex polygon",
                   "give one ring without holes that turns left at each vertex");
  }
  return found;
}

bool is_convex(const PolygonSet& set) { return ring_if_convex(set).size() > 0; }

}  // namespace minkref::inline plane
