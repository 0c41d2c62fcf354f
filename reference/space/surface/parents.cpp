#include "reference/space/surface/parents.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline space {
namespace {

/// Twice the signed area of a triangle.
Rational turned_area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A facet's corners as seen, counter-clockwise.
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
bool enters(const FilteredRing& convex, const FilteredPoint& from, const FilteredPoint& to) {
  std::vector<std::size_t> passed;  // sides on whose lines the segment changes sides
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const FilteredPoint &a = convex[k], &b = convex[(k + 1) % convex.size()];
    const bool starts = orientation(a, b, from) > 0, ends = orientation(a, b, to) > 0;
    if (!starts && !ends) return false;
    if (!starts || !ends) passed.push_back(k);
  }
  Rational first = 0, last = 1;
  for (const std::size_t k : passed) {
    const Point &a = convex[k].exact(), &b = convex[(k + 1) % convex.size()].exact();
    const Rational start = turned_area(a, b, from.exact()), end = turned_area(a, b, to.exact());
    const Rational at = start / (start - end);
    if (start <= 0) {
      first = std::max(first, at);
    } else {
      last = std::min(last, at);
    }
  }
  return first < last;
}

Box box_of(const FilteredPoint& p) {
  return {below(p.x()), below(p.y()), above(p.x()), above(p.y())};
}

/// A region's border, prepared for questions about many convex sets.
class RegionBorder {
 public:
  explicit RegionBorder(const PolygonSet& region) {
    for (const Polygon& polygon : region.polygons) {
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
    std::vector<Box> boxes;
    for (const auto& [a, b] : edges_) {
      boxes.push_back(box_of(a));
      boxes.back().add(box_of(b));
    }
    tree_ = BoxTree(std::move(boxes));
  }

  /// The region has area in common with an open convex set iff its border enters the set, or does
  /// not and holds all of it.
  bool overlaps(const FilteredRing& convex) const {
    Box box;
    for (const FilteredPoint& p : convex) box.add(box_of(p));
    const auto border_enters = [&](std::uint32_t k) {
      return enters(convex, edges_[k].first, edges_[k].second);
    };
    if (tree_.query(box, border_enters)) return true;
    // Looks from inside a triangle of corners, which has area.
    const Point &a = convex[0].exact(), &b = convex[1].exact(), &c = convex[2].exact();
    const FilteredPoint middle({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    Box ray = box_of(middle);
    ray.xmax = std::numeric_limits<double>::infinity();
    int winding = 0;
    tree_.query(ray, [&](std::uint32_t k) {
      return add_winding(edges_[k].first, edges_[k].second, middle, winding);
    });
    return winding > 0;
  }

 private:
  void add(const Ring& ring) {
    const FilteredRing filtered = filtered_ring(ring);
    for (std::size_t k = 0; k < filtered.size(); ++k) {
      edges_.emplace_back(filtered[k], filtered[(k + 1) % filtered.size()]);
    }
  }

  std::vector<std::pair<FilteredPoint, FilteredPoint>> edges_;
  BoxTree tree_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> parents(const PolyhedralSet& set,
                                                const std::vector<ConvolutionFacet>& facets,
                                                const Integer& denominator) {
  std::vector<std::vector<std::uint32_t>> result(set.faces.size());
  std::vector<std::optional<RegionBorder>> borders(set.faces.size());
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
    const FilteredRing ring = filtered_ring(seen_ring(facets[f], plane, unit));
    for (; at != set.faces.end() && at->plane == plane; ++at) {
      const auto face = static_cast<std::size_t>(at - set.faces.begin());
      if (!borders[face]) borders[face].emplace(at->region);
      if (borders[face]->overlaps(ring)) result[face].push_back(f);
    }
  }
  return result;
}

}  // namespace minkref::inline space
