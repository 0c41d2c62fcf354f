#include "reference/disc/features/feature_regions.hpp"

#include <map>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

class RegionFinder {
 public:
  RegionFinder(const DiscIndex& index, FeatureRadius radius)
      : index_(index),
        graph_(index.graph()),
        nodes_(graph_.events + graph_.gaps + graph_.reflex_vertices) {
    found_.radius = std::move(radius);
    found_.parts = boundary_parts(index, found_.radius.level);
    for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
      if (index.high(k) <= found_.radius.level)
        nodes_.join(graph_.halves[k].from, graph_.halves[k].to);
    }
  }

  FeatureRegions find() {
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      look_for_interrupt();
      if (index_.radius_number(node) > found_.radius.level) continue;
      const auto number = static_cast<std::uint32_t>(found_.features.size());
      const auto [at, is_new] = numbers_.try_emplace(nodes_.root(node), number);
      if (is_new) found_.features.emplace_back();
      found_.features[at->second].nodes.push_back(node);
    }
    for (const PartRing& ring : found_.parts.hidden_rings) feature_of(ring).rings.push_back(ring);
    count();
    return std::move(found_);
  }

 private:
  std::uint32_t lower_node(std::uint32_t half) const {
    return index_.rises(half) ? graph_.halves[half].from : graph_.halves[half].to;
  }
  FeatureRegion& feature_of(const PartRing& ring) {
    const std::uint32_t half = ring.parts.empty() ? graph_.walks[ring.walk].first
                                                  : found_.parts.hidden[ring.parts.front()].from;
    return found_.features[numbers_.at(nodes_.root(lower_node(half)))];
  }

  /// Polygons along a walk touch, and polygons around a feature hang together through chords. Each
  /// component has an outer ring, and each hole a ring.
  void count() {
    const DiagramEvents& diagram = index_.diagram();
    std::uint32_t polygons = 0;
    for (const OffsetEdge& edge : diagram.curves.edges) {
      polygons = std::max(polygons, edge.polygon + 1);
    }
    if (polygons == 0) {  // a point, or nothing
      found_.components = diagram.curves.patches.empty() ? 0 : 1;
      found_.holes = 0;
      return;
    }
    const auto walks = static_cast<std::uint32_t>(diagram.walks.walks.size());
    DisjointSets sets(polygons + walks + found_.features.size());
    for (std::uint32_t walk = 0; walk < walks; ++walk) {
      const BoundaryWalk& own = diagram.walks.walks[walk];
      for (std::uint32_t side = own.first; side < own.last; ++side) {
        sets.join(diagram.curves.edges[diagram.walks.sides[side].edge].polygon, polygons + walk);
      }
      const DiagramGraph::Walk& halves = graph_.walks[walk];
      for (std::uint32_t k = halves.first; k < halves.last; ++k) {
        if (index_.low(k) > found_.radius.level) continue;
        const std::uint32_t feature = numbers_.at(nodes_.root(lower_node(k)));
        sets.join(polygons + walk, polygons + walks + feature);
      }
    }
    found_.components = sets.count();
    found_.holes = found_.parts.visible_rings.size() - found_.components;
  }

  const DiscIndex& index_;
  const DiagramGraph& graph_;
  DisjointSets nodes_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  ///< features, by the root of their nodes
  FeatureRegions found_;
};

}  // namespace

FeatureRegions feature_regions(const DiscIndex& index,
                               const std::optional<Rational>& squared_radius) {
  const FloatEnvironment standard;
  return RegionFinder(index, feature_radius(index, squared_radius)).find();
}

std::vector<std::uint32_t> reflex_vertices(const DiscIndex& index) {
  std::vector<std::uint32_t> found;
  for (const BoundarySide& side : index.diagram().walks.sides) {
    if (side.ends_at_reflex) found.push_back(side.to);
  }
  return found;
}

}  // namespace minkref::inline disc
