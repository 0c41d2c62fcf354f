#include "reference/disc/features/near_bridges.hpp"

#include <algorithm>
#include <cmath>

#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

NearBridges::NearBridges(const DiscIndex& index, const MergeTree& tree, const Barcode& codes)
    : index_(index), tree_(tree), codes_(codes) {
  const FloatEnvironment standard;
  const OffsetCurves& curves = index.diagram().curves;
  for (std::uint32_t k = 0; k < curves.features.size(); ++k) {
    features_.push_back(rounded(curves, k));
  }
  const DiagramGraph& graph = index.graph();
  for (const std::vector<std::uint32_t>& halves : tree.rising) {
    starts_.push_back(static_cast<std::uint32_t>(rising_.size()));
    for (const std::uint32_t half : halves) {
      const DiagramHalf& own = graph.halves[half];
      rising_.push_back(
          {half, index.low(half), index.high(half), own.feature, graph.halves[own.twin].feature});
    }
  }
  starts_.push_back(static_cast<std::uint32_t>(rising_.size()));
}

NearBridges::Feature NearBridges::rounded(const OffsetCurves& curves, std::uint32_t feature) {
  const Site site = Site::of(curves, feature);
  if (site.is_point) return {true, to_double(site.point.x), to_double(site.point.y), 0};
  const RootNumber inverse = sqrt(RootNumber(Rational(1 / site.squared_length())));
  return {false, nearest_double(inverse * RootNumber(site.normal.x)),
          nearest_double(inverse * RootNumber(site.normal.y)),
          nearest_double(inverse * RootNumber(site.level()))};
}

/// The nearest point of a feature. To project a place makes its error no longer, so no coordinate's
/// more than 1.5 times as large.
BoundedPoint NearBridges::foot(const Feature& feature, const BoundedPoint& centre) const {
  constexpr double rounding = 0x1p-49;
  if (feature.is_point) {
    const double size = std::abs(feature.x) + std::abs(feature.y);
    return {feature.x, feature.y, 0x1p-53 * size};
  }
  const double height = feature.x * centre.x + feature.y * centre.y - feature.level;
  const double size = std::abs(centre.x) + std::abs(centre.y) + std::abs(feature.level);
  return {centre.x - height * feature.x, centre.y - height * feature.y,
          1.5 * centre.error + rounding * size};
}

void NearBridges::at(double radius, std::vector<NearBridge>& found) const {
  const FloatEnvironment standard;
  found.clear();
  const Rational exact = from_double(radius), squared = exact * exact;
  const DiscIndex::Place place = index_.place(squared);
  const std::uint32_t below = place.at_event ? place.gap - 1 : place.gap;
  const FrameRadius near = index_.in_frame(squared);
  // By tree node the feature alive at the radius that it is a part of: parents come after children.
  thread_local std::vector<std::uint32_t> live;
  live.assign(tree_.nodes.size(), MergeTree::none);
  for (auto node = static_cast<std::uint32_t>(tree_.nodes.size()); node-- > 0;) {
    const MergeNode& own = tree_.nodes[node];
    if (own.radius > below || own.parent == MergeTree::none) continue;
    live[node] = tree_.nodes[own.parent].radius <= below ? live[own.parent] : node;
  }
  for (std::uint32_t node = 0; node < live.size(); ++node) {
    if (live[node] == MergeTree::none) continue;
    for (std::uint32_t k = starts_[node]; k < starts_[node + 1]; ++k) {
      const Rising& own = rising_[k];
      if (own.low > below || below >= own.high) continue;
      const BoundedPoint centre = index_.corner(own.half, near);
      const BoundedPoint from = foot(features_[own.own], centre),
                         to = foot(features_[own.across], centre);
      const BoundedPoint told[3] = {index_.as_given(from), index_.as_given(to),
                                    index_.as_given(centre)};
      const double error = std::max({told[0].error, told[1].error, told[2].error});
      found.push_back({told[0].x, told[0].y, told[1].x, told[1].y, told[2].x, told[2].y, error,
                       live[node], codes_.bar_of[live[node]]});
    }
  }
}

}  // namespace minkref::inline disc
