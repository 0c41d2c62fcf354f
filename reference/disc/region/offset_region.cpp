#include "reference/disc/region/offset_region.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "reference/disc/convolution/arc_convolution.hpp"
#include "reference/disc/curves/origin_near.hpp"
#include "reference/disc/region/joined_polygons.hpp"
#include "reference/disc/region/simple_rings.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/lines.hpp"

namespace minkref::inline disc {
namespace {

/// The curves of consecutive pieces, by feature: pieces that go on as the same curve count once.
std::vector<std::uint32_t> curves_of(const StaticOffset& offset,
                                     const std::vector<std::uint32_t>& pieces) {
  const auto feature = [&](std::uint32_t piece) {
    return offset.at->curves().patches[offset.pieces[piece].patch].feature;
  };
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::uint32_t before = pieces[(k + pieces.size() - 1) % pieces.size()];
    const std::uint32_t own = feature(pieces[k]);
    if (feature(before) == own && goes_on(offset, before, pieces[k])) continue;
    found.push_back(own);
  }
  if (found.empty()) return {feature(pieces[0])};  // a circle
  return found;
}

/// `origin`: the frame's origin, already subtracted from P.
OffsetRegion region_of(const PolygonSet& P, const Point& origin, const Rational& squared_radius,
                       const BuildOptions& options, OffsetRoute route) {
  OffsetRegion region;
  region.origin = origin;
  const bool by_winding = route == OffsetRoute::paper;
  ArcConvolution convolution;
  if (by_winding) convolution = arc_convolution(P, squared_radius);
  region.offset =
      by_winding ? std::move(convolution.offset) : static_offset(P, squared_radius, options);
  const StaticOffset& offset = region.offset;
  const std::vector<std::uint32_t> joined =
      by_winding ? std::vector<std::uint32_t>() : joined_polygons(*offset.at, P.polygons.size());
  const auto component_of = [&](std::uint32_t piece) {
    if (by_winding) return convolution.component_of[piece];
    return joined[offset.at->curves().patches[offset.pieces[piece].patch].polygon];
  };
  std::map<std::uint32_t, FormComponent> of_root;
  std::set<std::uint32_t> with_outer;
  SimpleRings simple = simple_rings(offset);
  for (std::uint32_t k = 0; k < simple.rings.size(); ++k) {
    const std::vector<std::uint32_t>& pieces = simple.rings[k].pieces;
    const std::uint32_t root = component_of(pieces[0]);
    FormComponent& component = of_root[root];
    FormRing found{curves_of(offset, pieces), k};
    if (simple.rings[k].is_hole) {
      component.holes.push_back(std::move(found));
    } else if (with_outer.insert(root).second) {
      component.outer = std::move(found);
    } else {
      throw std::logic_error("a component of an offset has two outer rings");
    }
  }
  region.holes = simple.faces - of_root.size() - 1;
  if (by_winding &&
      (convolution.components != of_root.size() || convolution.holes != region.holes)) {
    throw std::logic_error("the rings of a convolution do not bound its faces");
  }
  OffsetForm form;
  for (auto& [root, component] : of_root) {
    if (!with_outer.contains(root)) {
      throw std::logic_error("a component of an offset has no outer ring");
    }
    form.push_back(std::move(component));
  }
  make_canonical(form, offset.at->curves());
  const auto ring = [&](FormRing& found) -> OffsetRing {
    return {std::move(simple.rings[found.id].pieces), std::move(found.curves)};
  };
  for (FormComponent& component : form) {
    region.components.push_back({ring(component.outer), {}});
    for (FormRing& hole : component.holes) region.components.back().holes.push_back(ring(hole));
  }
  return region;
}

}  // namespace

OffsetRoute offset_route_named(std::string_view name) {
  if (name == "definition") return OffsetRoute::definition;
  if (name == "paper") return OffsetRoute::paper;
  throw BadInput("unknown-route", "there is no route \"" + std::string(name) + "\" with a disc",
                 "choose definition or paper");
}

OffsetRegion offset_region(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options, OffsetRoute route) {
  const FloatEnvironment standard;
  if (squared_radius <= 0) {
    throw BadInput("bad-radius", "the square of the radius is " + to_string(squared_radius),
                   "give a radius above 0");
  }
  constexpr long margin = 4;  // in powers of two: sets as near as that stay where they are
  const PolygonSet parts = cut_lines(P);
  const Point origin = origin_near(parts, squared_radius, margin);
  if (origin == Point{0, 0}) return region_of(parts, origin, squared_radius, options, route);
  const PolygonSet moved = translated(parts, {-origin.x, -origin.y});
  return region_of(moved, origin, squared_radius, options, route);
}

std::string canonical_json(const OffsetRegion& region) {
  OffsetForm form;
  for (const OffsetComponent& component : region.components) {
    form.push_back({{component.outer.curves, 0}, {}});
    for (const OffsetRing& hole : component.holes) form.back().holes.push_back({hole.curves, 0});
  }
  return canonical_json(form, region.offset.at->curves(), region.offset.at->squared_radius(),
                        region.origin);
}

}  // namespace minkref::inline disc
