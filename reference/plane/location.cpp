#include "reference/plane/location.hpp"

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline plane {

bool add_winding(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& point,
                 int& winding) {
  const int ya = compare_y(a, point), yb = compare_y(b, point);
  if (ya == 0 && yb == 0) return compare_x(a, point) * compare_x(b, point) <= 0;
  if (ya * yb > 0) return false;
  const int side = orientation(a, b, point);
  if (side == 0) return true;
  // Upward edges with the point on their left and downward edges with the point on their right;
  // ends are half-open.
  if (ya <= 0 && yb > 0 && side > 0) ++winding;
  if (ya > 0 && yb <= 0 && side < 0) --winding;
  return false;
}

namespace {

/// Adds the ring's winding number around the point; returns whether the point lies on the ring.
bool add_winding(const FilteredRing& ring, const FilteredPoint& point, int& winding) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    look_for_interrupt();
    if (add_winding(ring[i], ring[(i + 1) % ring.size()], point, winding)) return true;
  }
  return false;
}

}  // namespace

FilteredRing filtered_ring(const Ring& ring) {
  FilteredRing result;
  result.reserve(ring.size());
  for (const Point& point : ring) result.emplace_back(point);
  return result;
}

Location locate(const FilteredRing& ring, const FilteredPoint& point) {
  const FloatEnvironment standard;
  int winding = 0;
  if (add_winding(ring, point, winding)) return Location::boundary;
  return winding != 0 ? Location::inside : Location::outside;
}

Location locate(const PolygonSet& set, const Point& point) {
  const FloatEnvironment standard;
  const FilteredPoint at(point);
  int winding = 0;
  for (const Polygon& polygon : set.polygons) {
    if (add_winding(filtered_ring(polygon.outer), at, winding)) return Location::boundary;
    for (const Ring& hole : polygon.holes) {
      if (add_winding(filtered_ring(hole), at, winding)) return Location::boundary;
    }
  }
  return winding > 0 ? Location::inside : Location::outside;
}

}  // namespace minkref::inline plane
