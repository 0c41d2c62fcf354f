// Regions of features and rest material, for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_features.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/features/feature_level.hpp"
#include "reference/disc/features/region_drawing.hpp"
#include "reference/disc/features/rest_measures.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using DiscBounds = std::pair<double, double>;
using AreaTerms = std::map<std::string, std::string>;
using PointText = std::pair<std::string, std::string>;
/// "line" or "arc", both ends, and an arc's centre.
using StepRow = std::tuple<std::string, double, double, double, double, double, double>;
/// The feature's node of the merge tree (none once it has ended, in a filled hole), numbers of
/// events, reflex vertices, the region's area, and its exact terms.
using RegionRow = std::tuple<std::optional<std::uint32_t>, std::vector<std::uint32_t>,
                             std::vector<PointText>, DiscBounds, AreaTerms>;
/// A corner's two feet.
using ChordRow = std::pair<PointText, PointText>;
/// An arc about a corner: the corner, both feet, and the corners whose circles it meets at both
/// ends; none at a foot.
using ArcRow =
    std::tuple<PointText, PointText, PointText, std::vector<PointText>, std::vector<PointText>>;

DiscBounds bounds_of(const Interval& value) { return {value.lower(), value.upper()}; }

AreaTerms rows_of(const RootTerms& terms) {
  AreaTerms rows;
  for (const auto& [product, factor] : terms.terms()) rows[product] = to_string(factor);
  return rows;
}

std::vector<StepRow> rows_of(const std::vector<DrawnStep>& steps) {
  std::vector<StepRow> rows;
  for (const DrawnStep& step : steps) {
    rows.emplace_back(step.is_arc ? "arc" : "line", step.x0, step.y0, step.x1, step.y1, step.cx,
                      step.cy);
  }
  return rows;
}

/// All regions at a radius, with rest material.
class RegionsAt {
 public:
  RegionsAt(const BoundFeatures& all, const std::optional<std::string>& squared)
      : all_(all),
        regions_(feature_regions(all.index,
                                 squared ? std::optional(parse_rational(*squared)) : std::nullopt)),
        outlines_(all.bridges, regions_) {
    const bool is_finite = regions_.radius.squared.has_value();
    if (is_finite) rest_ = rest_material(outlines_);
    const DiscIndex::Place place = is_finite ? all.index.place(parse_rational(*squared))
                                             : DiscIndex::Place{all.index.radii(), false};
    for (const LiveFeature& feature : features_at(all.index, all.tree, all.codes, place)) {
      live_.push_back(feature.node);
    }
  }

  std::size_t components() const { return regions_.components; }
  std::size_t holes() const { return regions_.holes; }

  std::vector<RegionRow> features() const {
    const std::vector<std::uint32_t> vertices = reflex_vertices(all_.index);
    const DiagramGraph& graph = all_.index.graph();
    std::vector<RegionRow> rows;
    for (const FeatureRegion& feature : regions_.features) {
      std::vector<std::uint32_t> events;
      std::vector<PointText> leaves;
      for (const std::uint32_t node : feature.nodes) {
        if (graph.is_event(node)) {
          events.push_back(node);
        } else {
          leaves.push_back(
              to_strings(all_.index.diagram().vertex(vertices[node - graph.events - graph.gaps])));
        }
      }
      const OutlineArea area = region_area(outlines_, feature);
      rows.emplace_back(live_node(feature), std::move(events), std::move(leaves),
                        bounds_of(area.bounds), rows_of(area.terms));
    }
    return rows;
  }

  std::pair<DiscBounds, AreaTerms> shape_area() const {
    const OutlineArea area = minkref::shape_area(outlines_);
    return {bounds_of(area.bounds), rows_of(area.terms)};
  }

  std::vector<DiscBounds> shape_rings() const {
    std::vector<DiscBounds> rows;
    for (const PartRing& ring : regions_.parts.visible_rings) {
      rows.push_back(bounds_of(ring_area(outlines_, ring, false).bounds));
    }
    return rows;
  }

  std::vector<ChordRow> chords(std::size_t number) const {
    std::vector<ChordRow> rows;
    for (const PartRing& ring : feature(number).rings) {
      for (const std::uint32_t part : ring.parts) {
        const Chord<RootNumber>& chord = outlines_.corners()[part].chord;
        rows.emplace_back(text_of(chord.from), text_of(chord.to));
      }
    }
    return rows;
  }

  std::vector<std::vector<PointText>> corners(std::size_t number) const {
    std::vector<std::vector<PointText>> rows;
    for (const PartRing& ring : feature(number).rings) {
      auto& row = rows.emplace_back();
      for (const OutlineStep& step : outlines_.outline(ring, true)) {
        row.push_back(text_of(step.from));
      }
    }
    return rows;
  }

  std::vector<std::vector<StepRow>> outlines(std::size_t number) const {
    std::vector<std::vector<StepRow>> rows;
    for (const PartRing& ring : feature(number).rings) {
      rows.push_back(rows_of(drawn_outline(outlines_, ring, true)));
    }
    return rows;
  }

  std::vector<std::pair<std::size_t, DiscBounds>> rest() const {
    std::vector<std::pair<std::size_t, DiscBounds>> rows;
    for (std::size_t k = 0; k < found_rest().features.size(); ++k) {
      rows.emplace_back(found_rest().features[k].components,
                        bounds_of(rest_area(outlines_, found_rest(), {k})));
    }
    return rows;
  }

  DiscBounds whole_rest() const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < found_rest().features.size(); ++k) all.push_back(k);
    return bounds_of(rest_area(outlines_, found_rest(), all));
  }

  std::vector<std::vector<StepRow>> rest_outlines(std::size_t number) const {
    feature(number);
    std::vector<std::vector<StepRow>> rows;
    for (const RestRing& ring : found_rest().features[number].rings) {
      rows.push_back(rows_of(drawn_rest(outlines_, found_rest(), ring)));
    }
    return rows;
  }

  std::vector<ArcRow> rest_arcs(std::size_t number) const {
    feature(number);
    std::vector<ArcRow> rows;
    for (const RestRing& ring : found_rest().features[number].rings) {
      for (const RestPiece& piece : ring.pieces) {
        if (!piece.is_arc) continue;
        const FreeArc& arc = found_rest().arcs[piece.number];
        const CornerBridge& corner = outlines_.corners()[arc.corner];
        rows.emplace_back(text_of(*corner.corner), text_of(corner.chord.from),
                          text_of(corner.chord.to), met(arc.from), met(arc.to));
      }
    }
    return rows;
  }

 private:
  /// The last node tells the feature.
  std::optional<std::uint32_t> live_node(const FeatureRegion& feature) const {
    const std::uint32_t last = *std::max_element(
        feature.nodes.begin(), feature.nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
          return all_.index.radius_number(a) < all_.index.radius_number(b);
        });
    const std::uint32_t node = all_.tree.feature_of[last];
    if (std::find(live_.begin(), live_.end(), node) == live_.end()) return std::nullopt;
    return node;
  }
  const FeatureRegion& feature(std::size_t number) const {
    if (number < regions_.features.size()) return regions_.features[number];
    throw BadInput("no-feature",
                   "there are " + std::to_string(regions_.features.size()) +
                       " features, and none with the number " + std::to_string(number),
                   "features count from 0 on");
  }
  const RestMaterial& found_rest() const {
    if (rest_) return *rest_;
    throw BadInput("bad-radius", "there is no rest material at an infinite radius",
                   "give a radius");
  }
  PointText text_of(const RootPoint& point) const {
    const RootPoint at = placed(outlines_, point);
    return {expression(at.x), expression(at.y)};
  }
  std::vector<PointText> met(const ArcEnd& end) const {
    std::vector<PointText> found;
    for (const std::uint32_t corner : end.with) {
      found.push_back(text_of(*outlines_.corners()[corner].corner));
    }
    return found;
  }

  const BoundFeatures& all_;
  FeatureRegions regions_;
  RegionOutlines outlines_;
  std::optional<RestMaterial> rest_;
  std::vector<std::uint32_t> live_;  ///< nodes of the merge tree
};

}  // namespace

void bind_feature_regions(nb::module_& module, nb::class_<BoundFeatures>& bound) {
  nb::class_<RegionsAt>(module, "RegionsAt",
                        "The regions of features, the alpha-shape and the rest at one radius.")
      .def_prop_ro("components", &RegionsAt::components,
                   "The alpha-shape's, as a closed set: touching sets count once.")
      .def_prop_ro("holes", &RegionsAt::holes, "Bounded components of the complement.")
      .def("features", &RegionsAt::features, Released(),
           "By feature: its node of the merge tree (None once a hole is filled), numbers of "
           "its events, its reflex vertices, its region's area between two doubles, and exactly as "
           "factors by products of roots.")
      .def("shape_area", &RegionsAt::shape_area, Released(),
           "The area of the alpha-shape, between two doubles and exactly.")
      .def("shape_rings", &RegionsAt::shape_rings, Released(),
           "The areas of the rings of the alpha-shape, negative around holes.")
      .def("chords", &RegionsAt::chords, "feature"_a, Released(),
           "Both feet of each corner of a feature, as expressions: its bridges.")
      .def("corners", &RegionsAt::corners, "feature"_a, Released(),
           "The corners of a region's rings in order, as expressions, the region on the right.")
      .def("outlines", &RegionsAt::outlines, "feature"_a, Released(),
           "A region's rings as (kind, x and y of the start, of the end, of an arc's centre), the "
           "region on the right. Nearest doubles.")
      .def("rest", &RegionsAt::rest, Released(),
           "By feature: components of the rest material, and its area between two doubles.")
      .def("rest_area", &RegionsAt::whole_rest, Released(),
           "The area of all rest material, between two doubles.")
      .def("rest_outlines", &RegionsAt::rest_outlines, "feature"_a, Released(),
           "Rings of the rest material as `outlines` has them; arcs run counter-clockwise.")
      .def("rest_arcs", &RegionsAt::rest_arcs, "feature"_a, Released(),
           "Arcs that bound the rest, as expressions: the corner, both feet, and the corners whose "
           "circles the arc meets at its start and at its end; none at a foot.");
  bound.def(
      "regions",
      [](const BoundFeatures& self, const std::optional<std::string>& squared_radius)
          -> RegionsAt* { return new RegionsAt(self, squared_radius); },
      "squared_radius"_a.none() = nb::none(), Released(), nb::keep_alive<0, 1>(),
      "Regions, alpha-shape and rest material at a radius; None: infinity. Raises BadInput.");
}

}  // namespace minkref::python
