#include "reference/disc/offset_region.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "reference/disc/arc_convolution.hpp"
#include "reference/disc/joined_polygons.hpp"
#include "reference/disc/simple_rings.hpp"
#include "reference/error.hpp"

namespace minkref::inline disc {
namespace {

/// From which place on a ring of numbers is least.
std::size_t least_start(const std::vector<std::uint32_t>& ring) {
  const std::size_t n = ring.size();
  std::size_t i = 0, j = 1, k = 0;  // two candidates that agree in k numbers
  while (i < n && j < n && k < n) {
    const std::uint32_t a = ring[(i + k) % n], b = ring[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

/// Curves by number, in the order of the canonical form: the same ones have one number.
class Curves {
 public:
  explicit Curves(const StaticOffset& offset) : offset_(offset) {
    const OffsetCurves& curves = offset.at->curves();
    std::map<std::uint32_t, OffsetCurve> used;
    for (const OffsetPiece& piece : offset.pieces) {
      const std::uint32_t feature = curves.patches[piece.patch].feature;
      if (!used.contains(feature)) used.emplace(feature, offset_curve(curves, feature));
    }
    std::vector<std::pair<OffsetCurve, std::uint32_t>> sorted;
    for (const auto& [feature, curve] : used) sorted.emplace_back(curve, feature);
    const auto key = [](const OffsetCurve& curve) {
      return std::tuple(!curve.is_arc, std::cref(curve.x), std::cref(curve.y), std::cref(curve.c));
    };
    const auto less = [&](const OffsetCurve& a, const OffsetCurve& b) {
      const auto u = key(a), v = key(b);
      if (std::get<0>(u) != std::get<0>(v)) return std::get<0>(u) < std::get<0>(v);
      if (a.x != b.x) return a.x < b.x;
      return a.y != b.y ? a.y < b.y : a.c < b.c;
    };
    std::sort(sorted.begin(), sorted.end(),
              [&](const auto& a, const auto& b) { return less(a.first, b.first); });
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      const bool is_new = k == 0 || less(sorted[k - 1].first, sorted[k].first);
      if (is_new) features_.push_back(sorted[k].second);
      numbers_[sorted[k].second] = static_cast<std::uint32_t>(features_.size() - 1);
    }
  }

  /// Of a ring, from the least on.
  std::vector<std::uint32_t> of(const std::vector<std::uint32_t>& pieces) const {
    std::vector<std::uint32_t> found;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const std::uint32_t before = pieces[(k + pieces.size() - 1) % pieces.size()];
      const std::uint32_t own = number_of(pieces[k]);
      if (number_of(before) == own && goes_on(offset_, before, pieces[k])) continue;
      found.push_back(own);
    }
    if (found.empty()) return {number_of(pieces[0])};  // a circle
    std::rotate(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(least_start(found)),
                found.end());
    return found;
  }

  std::uint32_t feature(std::uint32_t number) const { return features_[number]; }

 private:
  std::uint32_t number_of(std::uint32_t piece) const {
    const OffsetPiece& own = offset_.pieces[piece];
    return numbers_.at(offset_.at->curves().patches[own.patch].feature);
  }

  const StaticOffset& offset_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  ///< by feature
  std::vector<std::uint32_t> features_;             ///< one of each
};

void append(std::string& text, const Rational& number) {
  text += '"';
  text += to_string(number);
  text += '"';
}

void append(std::string& text, const OffsetRing& ring, const OffsetCurves& curves) {
  text += '[';
  for (std::size_t k = 0; k < ring.curves.size(); ++k) {
    const OffsetCurve curve = offset_curve(curves, ring.curves[k]);
    text += k == 0 ? "[" : ",[";
    text += curve.is_arc ? "\"arc\"," : "\"line\",";
    append(text, curve.x);
    text += ',';
    append(text, curve.y);
    if (!curve.is_arc) {
      text += ',';
      append(text, curve.c);
    }
    text += ']';
  }
  text += ']';
}

}  // namespace

OffsetCurve offset_curve(const OffsetCurves& curves, std::uint32_t feature) {
  const OffsetCurves::Feature& own = curves.features[feature];
  if (own.edge == OffsetPatch::none) return {true, own.centre.x, own.centre.y, 0};
  const OffsetEdge& edge = curves.edges[own.edge];
  const auto [dx, dy] = primitive(edge.along);
  return {false, dx, dy, dy * edge.start.x - dx * edge.start.y};
}

OffsetRoute offset_route_named(std::string_view name) {
  if (name == "definition") return OffsetRoute::definition;
  if (name == "paper") return OffsetRoute::paper;
  throw BadInput("unknown-route", "there is no route \"" + std::string(name) + "\" with a disc",
                 "choose definition or paper");
}

OffsetRegion offset_region(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options, OffsetRoute route) {
  if (squared_radius <= 0) {
    throw BadInput("bad-radius", "the square of the radius is " + to_string(squared_radius),
                   "give a radius above 0");
  }
  OffsetRegion region;
  const bool by_winding = route == OffsetRoute::paper;
  ArcConvolution convolution;
  if (by_winding) convolution = arc_convolution(P, squared_radius);
  region.offset =
      by_winding ? std::move(convolution.offset) : static_offset(P, squared_radius, options);
  const StaticOffset& offset = region.offset;
  const Curves curves(offset);
  const std::vector<std::uint32_t> joined =
      by_winding ? std::vector<std::uint32_t>() : joined_polygons(*offset.at, P.polygons.size());
  const auto component_of = [&](std::uint32_t piece) {
    if (by_winding) return convolution.component_of[piece];
    return joined[offset.at->curves().patches[offset.pieces[piece].patch].polygon];
  };
  std::map<std::uint32_t, OffsetComponent> of_root;
  SimpleRings simple = simple_rings(offset);
  for (SimpleRing& ring : simple.rings) {
    OffsetRing found{std::move(ring.pieces), {}};
    found.curves = curves.of(found.pieces);
    OffsetComponent& component = of_root[component_of(found.pieces[0])];
    if (ring.is_hole) {
      component.holes.push_back(std::move(found));
    } else if (component.outer.pieces.empty()) {
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
  const auto less = [](const OffsetRing& a, const OffsetRing& b) { return a.curves < b.curves; };
  for (auto& [root, component] : of_root) {
    if (component.outer.pieces.empty()) {
      throw std::logic_error("a component of an offset has no outer ring");
    }
    std::sort(component.holes.begin(), component.holes.end(), less);
    region.components.push_back(std::move(component));
  }
  std::sort(
      region.components.begin(), region.components.end(),
      [&](const OffsetComponent& a, const OffsetComponent& b) { return less(a.outer, b.outer); });
  for (OffsetComponent& component : region.components) {
    const auto name = [&](OffsetRing& ring) {
      for (std::uint32_t& curve : ring.curves) curve = curves.feature(curve);
    };
    name(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), name);
  }
  return region;
}

std::string canonical_json(const OffsetRegion& region) {
  const OffsetCurves& curves = region.offset.at->curves();
  std::string text = "{\"components\":[";
  for (std::size_t k = 0; k < region.components.size(); ++k) {
    const OffsetComponent& component = region.components[k];
    text += k == 0 ? "{\"holes\":[" : ",{\"holes\":[";
    for (std::size_t h = 0; h < component.holes.size(); ++h) {
      if (h > 0) text += ',';
      append(text, component.holes[h], curves);
    }
    text += "],\"outer\":";
    append(text, component.outer, curves);
    text += '}';
  }
  text += "],\"squared_radius\":";
  append(text, region.offset.at->squared_radius());
  text += '}';
  return text;
}

}  // namespace minkref::inline disc
