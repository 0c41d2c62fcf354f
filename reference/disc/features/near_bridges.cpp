#include "reference/disc/features/near_bridges.hpp"

#include <algorithm>
#include <cmath>

#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

namespace {

constexpr double rounded_up = 1 + 0x1p-40;
constexpr double least = 0x1p-1070;  // more than what is lost below the range of doubles

}  // namespace

NearBridges::NearBridges(const DiscIndex& index, const MergeTree& tree, const Barcode& codes)
    : index_(index), codes_(codes) {
  const FloatEnvironment standard;
  const OffsetCurves& curves = index.diagram().curves;
  scale_ = to_double(Rational(1 / index.diagram().factor));
  x_ = to_double(index.diagram().origin.x);
  y_ = to_double(index.diagram().origin.y);
  origin_error_ = 0x1p-52 * (std::abs(x_) + std::abs(y_));
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
  for (const MergeNode& node : tree.nodes) {
    const bool is_root = node.parent == MergeTree::none;
    lives_.push_back({is_root ? MergeTree::none : node.radius,
                      is_root ? MergeTree::none : tree.nodes[node.parent].radius, node.parent});
  }
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
  thread_local std::vector<std::uint32_t> of_thread;
  of_thread.resize(lives_.size());
  std::uint32_t* const live = of_thread.data();
  const auto nodes = static_cast<std::uint32_t>(lives_.size());
  for (std::uint32_t node = nodes; node-- > 0;) {
    const Life& own = lives_[node];
    live[node] = own.from > below ? MergeTree::none : own.to <= below ? live[own.parent] : node;
  }
  for (std::uint32_t node = 0; node < nodes; ++node) {
    if (live[node] == MergeTree::none) continue;
    for (std::uint32_t k = starts_[node]; k < starts_[node + 1]; ++k) {
      const Rising& own = rising_[k];
      if (own.low > below || below >= own.high) continue;
      const BoundedPoint centre = index_.corner(own.half, near);
      const BoundedPoint from = foot(features_[own.own], centre),
                         to = foot(features_[own.across], centre);
      double size = 0;
      const auto place = [&](const BoundedPoint& in_frame, double& x, double& y) {
        const double across = in_frame.x * scale_, up = in_frame.y * scale_;
        size = std::max(size, std::abs(across) + std::abs(up));
        x = across + x_;
        y = up + y_;
      };
      NearBridge bridge;
      place(from, bridge.from_x, bridge.from_y);
      place(to, bridge.to_x, bridge.to_y);
      place(centre, bridge.x, bridge.y);
      const double widest = std::max({from.error, to.error, centre.error});
      bridge.error = (widest * scale_ + origin_error_ + 0x1p-52 * size + least) * rounded_up;
      bridge.feature = live[node];
      bridge.bar = codes_.bar_of[live[node]];
      found.push_back(bridge);
    }
  }
}

}  // namespace minkref::inline disc
