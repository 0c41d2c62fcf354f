// Boundary and topology events of the sum as the scale grows, with the identity of each hole and
// component.
#pragma once

#include <functional>
#include <optional>

#include "reference/plane/history/boundary_regions.hpp"

namespace minkref::inline plane {

enum class FeatureKind : std::uint8_t {
  hole,      ///< bounded connected component of the complement
  component  ///< connected component of the interior
};

/// A hole or component through the scales. It exists at the scales between `born` and `died`; a
/// hole is open, and exists at its scale of birth or death only if a split bears it or a merge ends
/// it (docs/definitions.md, "Critical scales").
struct Feature {
  std::optional<std::uint32_t> born, died;  ///< groups; none: there when the window begins or ends
};

/// A change of holes, or of components, at one place and scale.
struct TopologyEvent {
  enum class Change : std::uint8_t { birth, death, merge, split, touch };
  std::uint32_t group = 0;
  FeatureKind kind = FeatureKind::hole;
  Change change = Change::birth;
  std::vector<std::uint32_t> before, after;  ///< features; of holes, 0 is the outside
  std::size_t at = 0;  ///< count at the scale itself: parts of `before` and of `after`
  Point place;         ///< where features touch, or where one vanishes or appears
};

struct TopologyTimeline {
  std::vector<Feature> holes;  ///< 0 is the outside
  std::vector<Feature> components;
  std::vector<TopologyEvent> topology;  ///< sorted by group
  std::vector<BoundaryEvent> boundary;  ///< sorted by group
  /// Numbers below the first group that touches the boundary, and for each such group at its scale
  /// and during the interval above.
  struct Count {
    std::uint32_t interval = 0, holes = 0, components = 0, vertices = 0;
    std::uint32_t holes_at = 0, components_at = 0;  ///< at the scale where the interval begins
  };
  std::vector<Count> counts;
};

/// The boundary's rings, unordered, from `interval` on; `component` and `hole` are features.
struct RingsFrom {
  std::uint32_t interval = 0;
  std::vector<BoundaryRing> rings;
};

/// The features that each sub-edge of an interval bounds, on its right and on its left.
struct FeaturesFrom {
  std::uint32_t interval = 0;
  std::vector<std::uint32_t> sub_edges, holes, components;
};

/// Exact. O(g b) for g groups that are not quiet and touch a boundary of b sub-edges. A splitting
/// hole goes on as its largest part; of merging holes the oldest goes on, and the outside counts as
/// older than any; places order the new names. `rings` and `features` are called for the first
/// state; then `rings` for each state after a boundary event, `features` after each group that is
/// not quiet. `counts` has the latter only.
TopologyTimeline topology_timeline(const BoundaryHistory& history,
                                   const std::function<void(RingsFrom)>& rings = {},
                                   const std::function<void(FeaturesFrom)>& features = {});

}  // namespace minkref::inline plane
