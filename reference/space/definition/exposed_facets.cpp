#include "reference/space/definition/exposed_facets.hpp"

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/space/definition/body_search.hpp"

namespace minkref::inline space {
namespace {

/// The distance between two boxes' middles; only to try the likely largest cover first.
double distance(const CornerBox& ring, const SumBody& body) {
  const Box &a = ring.flat, &b = body.flat_box;
  const double apart = std::abs(a.xmin + a.xmax - b.xmin - b.xmax) +
                       std::abs(a.ymin + a.ymax - b.ymin - b.ymax) +
                       std::abs(ring.bottom + ring.top - body.bottom - body.top);
  return std::isnan(apart) ? 0 : apart;  // beyond the doubles
}

enum class Cover { none, some, all };

/// How much of a convex polygon in `plane` the body covers just above, as far as the body's planes
/// tell one by one; the body covers its own facets in the same plane only if `comes_before`.
Cover cover_of(const CornerRing& ring, const OrientedPlane& plane, const SumBody& body,
               bool comes_before) {
  Cover cover = Cover::all;
  for (const SumFacet& facet : body.facets) {
    bool above = false, below = false;
    for (auto corner = ring.begin(); corner != ring.end() && !(above && below); ++corner) {
      const int side = facet.plane.side(*corner);
      above = above || side > 0;
      below = below || side < 0;
    }
    if (above && !below) return Cover::none;
    if (above) cover = Cover::some;
    const bool same_plane = !above && !below;
    const bool faces_alike = facet.plane.plane().normal == plane.normal;
    if (same_plane && faces_alike && !comes_before) return Cover::none;
  }
  return cover;
}

/// A part of a facet, and the bodies that may cover some of it, likely large covers first.
struct FacetPart {
  CornerRing ring;
  std::vector<std::uint32_t> bodies;
};

class UnionBoundary {
 public:
  explicit UnionBoundary(const std::vector<SumBody>& bodies) : bodies_(bodies), search_(bodies) {}

  PolyhedralSet boundary() {
    std::map<OrientedPlane, PolygonSet> planes;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const SumFacet& facet : bodies_[b].facets) {
        look_for_interrupt();
        const OrientedPlane& plane = facet.plane.plane();
        const std::size_t axis = viewing_axis(plane.normal);
        for (const CornerRing& part : exposed(b, facet)) {
          Ring ring;
          for (const SolidCorner& corner : part) ring.push_back(seen(exact_point(corner), axis));
          planes[plane].polygons.push_back({std::move(ring), {}});
        }
      }
    }
    PolyhedralSet set;
    for (auto& [plane, parts] : planes) {
      look_for_interrupt_now();
      orient(parts);
      set.faces.push_back({plane, canonicalize(parts).region});
    }
    return set;
  }

 private:
  /// The facet's parts that no body other than `own` covers.
  std::vector<CornerRing> exposed(std::size_t own, const SumFacet& facet) {
    const CornerBox box(facet.ring);
    if (covered_as_others_were(own, facet, box)) return {};
    near_.clear();
    search_.near(box, [&](std::uint32_t b) {
      if (b != own) near_.emplace_back(distance(box, bodies_[b]), b);
    });
    std::partial_sort(near_.begin(),
                      near_.begin() + std::min<std::ptrdiff_t>(16, std::ssize(near_)), near_.end());
    std::vector<FacetPart> open{{facet.ring, {}}};
    for (const auto& [apart, b] : near_) open[0].bodies.push_back(b);
    std::vector<CornerRing> found;
    while (!open.empty()) {
      FacetPart part = std::move(open.back());
      open.pop_back();
      if (!keep_cutters(part, own, facet.plane.plane())) continue;
      if (part.bodies.empty()) {
        found.push_back(std::move(part.ring));
        continue;
      }
      const SumBody& first = bodies_[part.bodies[0]];
      part.bodies.erase(part.bodies.begin());
      for (CornerRing& outer : parts_outside(part.ring, first)) {
        open.push_back({std::move(outer), part.bodies});
      }
    }
    return found;
  }

  /// Whether a body from a short list covers the facet: bodies at the same distance in the list
  /// from `own` as earlier covering bodies had from theirs. Such bodies often share a piece the
  /// same way.
  bool covered_as_others_were(std::size_t own, const SumFacet& facet, const CornerBox& box) {
    for (auto step = steps_.begin(); step != steps_.end(); ++step) {
      const auto at = static_cast<std::ptrdiff_t>(own) + *step;
      if (at < 0 || at >= std::ssize(bodies_)) continue;
      const auto b = static_cast<std::size_t>(at);
      if (!box.overlaps(bodies_[b])) continue;
      if (cover_of(facet.ring, facet.plane.plane(), bodies_[b], b < own) != Cover::all) continue;
      steps_.splice(steps_.begin(), steps_, step);
      return true;
    }
    return false;
  }

  /// Drops bodies that cover nothing; returns false if one body covers the whole part.
  bool keep_cutters(FacetPart& part, std::size_t own, const OrientedPlane& plane) {
    const CornerBox box(part.ring);
    std::vector<std::uint32_t> cutters;
    for (const std::uint32_t b : part.bodies) {
      look_for_interrupt();
      if (!box.overlaps(bodies_[b])) continue;
      const Cover cover = cover_of(part.ring, plane, bodies_[b], b < own);
      if (cover == Cover::all) {
        steps_.push_front(static_cast<std::ptrdiff_t>(b) - static_cast<std::ptrdiff_t>(own));
        if (steps_.size() > most_steps) steps_.pop_back();
        return false;
      }
      if (cover == Cover::some) cutters.push_back(b);
    }
    part.bodies = std::move(cutters);
    return true;
  }

  const std::vector<SumBody>& bodies_;
  BodySearch search_;
  std::vector<std::pair<double, std::uint32_t>> near_;
  static constexpr std::size_t most_steps = 24;
  std::list<std::ptrdiff_t> steps_;  ///< the last ones first
};

}  // namespace

std::vector<CornerRing> parts_outside(const CornerRing& ring, const SumBody& body) {
  std::vector<CornerRing> parts;
  CornerRing inner = ring;
  for (const SumFacet& facet : body.facets) {
    const RingSides sides = sides_of(inner, facet.plane);
    if (!sides.above) continue;
    if (!sides.below) return {ring};
    auto [below, above] = halves(inner, sides, facet.plane);
    parts.push_back(std::move(above));
    inner = std::move(below);
  }
  return parts;
}

PolyhedralSet boundary_of_union(const std::vector<SumBody>& bodies) {
  return UnionBoundary(bodies).boundary();
}

}  // namespace minkref::inline space
