#include "reference/space/definition/exposed_facets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/boundary/canonical.hpp"

namespace minkref::inline space {
namespace {

/// The box of a ring, in doubles that enclose it.
struct RingBox {
  Box flat;
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  explicit RingBox(const CornerRing& ring) {
    for (const auto& [rounded, exact] : ring) {
      const auto& [x, y, z] = rounded;
      flat.add({below(x), below(y), above(x), above(y)});
      bottom = std::min(bottom, below(z));
      top = std::max(top, above(z));
    }
  }
  bool overlaps(const SumBody& body) const {
    return flat.overlaps(body.flat_box) && bottom <= body.top && body.bottom <= top;
  }
};

/// How far apart the middles of two boxes are; only to look first where there is most to be taken.
double distance(const RingBox& ring, const SumBody& body) {
  const Box &a = ring.flat, &b = body.flat_box;
  return std::abs(a.xmin + a.xmax - b.xmin - b.xmax) + std::abs(a.ymin + a.ymax - b.ymin - b.ymax) +
         std::abs(ring.bottom + ring.top - body.bottom - body.top);
}

/// Takes from a convex polygon in `plane` what `body` covers just above it; the body covers its own
/// facets in the same plane where `comes_before`. What is left goes to `rest`.
void take_covered(const CornerRing& ring, const OrientedPlane& plane, const SumBody& body,
                  bool comes_before, std::vector<CornerRing>& rest) {
  std::vector<const CuttingPlane*> cutters;
  for (const SumFacet& facet : body.facets) {
    const RingSides sides = sides_of(ring, facet.plane);
    if (sides.below) {
      if (sides.above) cutters.push_back(&facet.plane);
      continue;
    }
    const bool same_plane = !sides.above;
    const bool covers = same_plane && (comes_before || facet.plane.plane().normal != plane.normal);
    if (covers) continue;
    rest.push_back(ring);
    return;
  }
  std::vector<CornerRing> left;
  CornerRing inner = ring;
  for (const CuttingPlane* cutter : cutters) {
    const RingSides sides = sides_of(inner, *cutter);
    if (!sides.below) {  // the body does not meet the polygon at all
      rest.push_back(ring);
      return;
    }
    if (!sides.above) continue;
    auto [below, above] = halves(inner, sides, *cutter);
    left.push_back(std::move(above));
    inner = std::move(below);
  }
  std::move(left.begin(), left.end(), std::back_inserter(rest));
}

class UnionBoundary {
 public:
  explicit UnionBoundary(const std::vector<SumBody>& bodies) : bodies_(bodies) {
    std::vector<Box> boxes;
    for (const SumBody& body : bodies) boxes.push_back(body.flat_box);
    tree_ = BoxTree(std::move(boxes));
  }

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
  /// What no other body covers of a facet of body `own`.
  std::vector<CornerRing> exposed(std::size_t own, const SumFacet& facet) {
    const RingBox box(facet.ring);
    near_.clear();
    tree_.query(box.flat, [&](std::uint32_t b) {
      if (b != own && box.overlaps(bodies_[b])) near_.emplace_back(distance(box, bodies_[b]), b);
      return false;
    });
    std::sort(near_.begin(), near_.end());
    std::vector<CornerRing> parts{facet.ring};
    for (const auto& [apart, b] : near_) {
      if (parts.empty()) break;
      std::vector<CornerRing> rest;
      for (CornerRing& part : parts) {
        look_for_interrupt();
        take_covered(part, facet.plane.plane(), bodies_[b], b < own, rest);
      }
      parts = std::move(rest);
    }
    return parts;
  }

  const std::vector<SumBody>& bodies_;
  BoxTree tree_;
  std::vector<std::pair<double, std::uint32_t>> near_;
};

}  // namespace

PolyhedralSet boundary_of_union(const std::vector<SumBody>& bodies) {
  return UnionBoundary(bodies).boundary();
}

}  // namespace minkref::inline space
