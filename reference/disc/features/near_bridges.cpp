#include "reference/disc/features/near_bridges.hpp"

#include <algorithm>
#include <cmath>

#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

namespace {

constexpr double rounded_up = 1 + 0x1p-40;
constexpr std::uint32_t most_spans = 32;
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
  std::vector<Feature> features;
  for (std::uint32_t k = 0; k < curves.features.size(); ++k) {
    features.push_back(rounded(curves, k));
  }
  part_gaps(tree, features);
}

/// Into spans, each with its bridges ready: a query walks over those that its span has.
void NearBridges::part_gaps(const MergeTree& tree, const std::vector<Feature>& features) {
  for (const MergeNode& node : tree.nodes) {
    const bool is_root = node.parent == MergeTree::none;
    lives_.push_back({is_root ? MergeTree::none : tree.nodes[node.parent].radius, node.parent});
  }
  const std::uint32_t gaps = index_.radii() + 1;
  gaps_of_span_ = (gaps + most_spans - 1) / most_spans;
  spans_.resize((gaps + gaps_of_span_ - 1) / gaps_of_span_);
  const DiagramGraph& graph = index_.graph();
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    for (const std::uint32_t half : tree.rising[node]) {
      const DiagramHalf& own = graph.halves[half];
      const auto number = static_cast<std::uint32_t>(rising_.size());
      rising_.push_back({index_.motion(half), features[own.feature],
                         features[graph.halves[own.twin].feature], half});
      const std::uint32_t low = std::max(index_.low(half), tree.nodes[node].radius),
                          high = std::min(index_.high(half), gaps);
      std::uint32_t feature = node;
      for (std::uint32_t first = low; first < high;) {
        while (lives_[feature].to <= first) feature = lives_[feature].parent;
        const std::uint32_t span = first / gaps_of_span_;
        spans_[span].push_back({low, high, number, feature});
        first = (span + 1) * gaps_of_span_;
      }
    }
  }
}

NearBridges::Feature NearBridges::rounded(const OffsetCurves& curves, std::uint32_t feature) {
  const Site site = Site::of(curves, feature);
  if (site.is_point) {
    const double x = to_double(site.point.x), y = to_double(site.point.y);
    return {x, y, 0, 0, 0, 0, 0x1p-53 * (std::abs(x) + std::abs(y))};
  }
  const RootNumber inverse = sqrt(RootNumber(Rational(1 / site.squared_length())));
  return {0,
          0,
          1,
          nearest_double(inverse * RootNumber(site.normal.x)),
          nearest_double(inverse * RootNumber(site.normal.y)),
          nearest_double(inverse * RootNumber(site.level())),
          0};
}

/// The nearest point of a feature, without a branch. To project a place makes its error no longer,
/// so no coordinate's more than 1.5 times as large.
inline __attribute__((always_inline)) BoundedPoint NearBridges::foot(const Feature& feature,
                                                                     const BoundedPoint& centre) {
  constexpr double rounding = 0x1p-49;
  const double height = feature.x * centre.x + feature.y * centre.y - feature.level;
  const double size = std::abs(centre.x) + std::abs(centre.y) + std::abs(feature.level);
  return {feature.base_x + feature.share * (centre.x - height * feature.x),
          feature.base_y + feature.share * (centre.y - height * feature.y),
          feature.error + feature.share * (1.5 * centre.error + rounding * size)};
}

/// Fills in a bridge's ends and centre.
void NearBridges::place(const Rising& own, const FrameRadius& radius, NearBridge& found) const {
  BoundedPoint centre = corner_of(own.motion, radius.near, radius.off);
  if (!(centre.error <= radius.widest_error())) centre = index_.corner_from_roots(own.half, radius);
  const BoundedPoint from = foot(own.own, centre), to = foot(own.across, centre);
  double size = 0;
  const auto put = [&](const BoundedPoint& in_frame, double& x, double& y) {
    const double across = in_frame.x * scale_, up = in_frame.y * scale_;
    size = std::max(size, std::abs(across) + std::abs(up));
    x = across + x_;
    y = up + y_;
  };
  put(from, found.from_x, found.from_y);
  put(to, found.to_x, found.to_y);
  put(centre, found.x, found.y);
  const double widest = std::max({from.error, to.error, centre.error});
  found.error = (widest * scale_ + origin_error_ + 0x1p-52 * size + least) * rounded_up;
}

void NearBridges::at(double radius, std::vector<NearBridge>& found) const {
  const FloatEnvironment standard;
  const Rational exact = from_double(radius);
  const DiscIndex::Place where = index_.place(exact * exact);
  const std::uint32_t below = where.at_event ? where.gap - 1 : where.gap;
  const FrameRadius near = index_.frame_radius(exact);
  const std::vector<Part>& parts = spans_[below / gaps_of_span_];
  found.resize(parts.size());
  NearBridge* next = found.data();
  for (const Part& part : parts) {
    if (part.low > below || below >= part.high) continue;
    next->feature = part.node;
    while (lives_[next->feature].to <= below) next->feature = lives_[next->feature].parent;
    next->bar = codes_.bar_of[next->feature];
    place(rising_[part.rising], near, *next++);
  }
  found.resize(static_cast<std::size_t>(next - found.data()));
}

}  // namespace minkref::inline disc
