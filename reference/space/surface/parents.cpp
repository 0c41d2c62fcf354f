#include "reference/space/surface/parents.hpp"

#include <algorithm>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline space {
namespace {

/// Twice the signed area of a triangle.
Rational turned_area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners of a facet as they are seen, counter-clockwise.
Ring seen_ring(const ConvolutionFacet& facet, const OrientedPlane& plane, const Rational& unit) {
  Ring ring;
  for (std::size_t k = 0; k < facet.size; ++k) {
    const IntegerVector& corner = facet.corners[k].exact;
    const SpacePoint point{Rational(corner[0]) * unit, Rational(corner[1]) * unit,
                           Rational(corner[2]) * unit};
    ring.push_back(seen(point, viewing_axis(plane.normal)));
  }
  if (is_mirrored(plane)) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Whether a closed segment enters the open inside of a convex ring.
bool enters(const Ring& convex, const Point& from, const Point& to) {
  Rational first = 0, last = 1;
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const Point &a = convex[k], &b = convex[(k + 1) % convex.size()];
    const Rational start = turned_area(a, b, from), end = turned_area(a, b, to);
    if (start <= 0 && end <= 0) return false;
    if (start > 0 && end > 0) continue;
    const Rational at = start / (start - end);
    if (start <= 0) {
      first = std::max(first, at);
    } else {
      last = std::min(last, at);
    }
  }
  return first < last;
}

/// A region has area in common with an open convex set iff its border enters the set, or does not
/// and holds all of it.
bool overlap(const PolygonSet& region, const Ring& convex) {
  Point least = convex[0], most = convex[0];
  for (const Point& p : convex) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  const auto ring_enters = [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
      if ((p.x <= least.x && q.x <= least.x) || (p.x >= most.x && q.x >= most.x) ||
          (p.y <= least.y && q.y <= least.y) || (p.y >= most.y && q.y >= most.y)) {
        continue;
      }
      if (enters(convex, p, q)) return true;
    }
    return false;
  };
  for (const Polygon& polygon : region.polygons) {
    look_for_interrupt();
    if (ring_enters(polygon.outer)) return true;
    if (std::any_of(polygon.holes.begin(), polygon.holes.end(), ring_enters)) return true;
  }
  // Within a triangle of corners, which is not flat.
  const Point &a = convex[0], &b = convex[1], &c = convex[2];
  return locate(region, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}) == Location::inside;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> parents(const PolyhedralSet& set,
                                                const std::vector<ConvolutionFacet>& facets,
                                                const Integer& denominator) {
  std::vector<std::vector<std::uint32_t>> result(set.faces.size());
  const Rational unit(Integer(1), denominator);
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    look_for_interrupt();
    const IntegerVector normal = primitive(facets[f].normal.exact);
    const OrientedPlane plane{normal,
                              Rational(dot(normal, facets[f].corners[0].exact), denominator)};
    auto at = std::lower_bound(
        set.faces.begin(), set.faces.end(), plane,
        [](const PlaneRegion& face, const OrientedPlane& sought) { return face.plane < sought; });
    if (at == set.faces.end() || !(at->plane == plane)) continue;
    const Ring ring = seen_ring(facets[f], plane, unit);
    for (; at != set.faces.end() && at->plane == plane; ++at) {
      if (overlap(at->region, ring)) {
        result[static_cast<std::size_t>(at - set.faces.begin())].push_back(f);
      }
    }
  }
  return result;
}

}  // namespace minkref::inline space
