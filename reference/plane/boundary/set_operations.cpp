#include "reference/plane/boundary/set_operations.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "reference/number/float_environment.hpp"

namespace minkref::inline plane {
namespace {

PolygonSet together(std::span<const PolygonSet> sets) {
  PolygonSet rings;
  for (const PolygonSet& set : sets) {
    if (set.is_region()) std::ranges::copy(set.polygons, std::back_inserter(rings.polygons));
  }
  return rings;
}

/// The points around which `rings` wind so often at least.
Canonical wound(const PolygonSet& rings, int least) {
  if (rings.empty()) return {};
  return canonical_form(set_boundary(rings, least).graph);
}

void add_reversed(PolygonSet& rings, const PolygonSet& set) {
  const auto add = [&](Ring ring) {
    std::ranges::reverse(ring);
    rings.polygons.push_back({std::move(ring), {}});
  };
  for (const Polygon& polygon : set.polygons) {
    add(polygon.outer);
    std::ranges::for_each(polygon.holes, add);
  }
}

}  // namespace

Canonical combined(SetOperation operation, const std::vector<PolygonSet>& sets) {
  const FloatEnvironment standard;
  if (sets.empty()) return {};
  switch (operation) {
    case SetOperation::unite:
      return wound(together(sets), 1);
    case SetOperation::intersect:
      return wound(together(sets), static_cast<int>(sets.size()));
    case SetOperation::subtract:
      break;
  }
  const std::span<const PolygonSet> all(sets);
  PolygonSet rings = together(all.first(1));
  if (rings.empty()) return {};
  add_reversed(rings, wound(together(all.subspan(1)), 1).region);
  return wound(rings, 1);
}

Canonical filled(const PolygonSet& rings, FillRule rule) {
  const FloatEnvironment standard;
  if (rings.empty()) return {};
  const SetBoundary boundary = set_boundary(rings, rule);
  Canonical result = canonical_form(boundary.graph);
  result.well_formed = boundary.well_formed;
  return result;
}

}  // namespace minkref::inline plane
