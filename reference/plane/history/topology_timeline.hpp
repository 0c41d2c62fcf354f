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

/// A hole or component through the scales. It is there at the scales between `born` and `died`; a
/// hole is open and a scale of birth or death has it only if it is born by a split or dies by a
/// merge (docs/definitions.md, "Critical scales").
struct Feature {
  std::optional<std::uint32_t> born, died;  ///< groups; none: there when the window begins or ends
};

/// A change of holes, or of components, in one place at one scale.
struct TopologyEvent {
  enum class Change : std::uint8_t { birth, death, merge, split, touch };
  std::uint32_t group = 0;
  FeatureKind kind = FeatureKind::hole;
  Change change = Change::birth;
  std::vector<std::uint32_t> before, after;  ///< features; of holes, 0 is the outside
  std::size_t at = 0;  ///< how many there are at the scale itself: parts of `before` and of `after`
  Point place;         ///< where features touch, or where one vanishes or appears
};

struct TopologyTimeline {
  std::vector<Feature> holes;  ///< 0 is the outside
  std::vector<Feature> components;
  std::vector<TopologyEvent> topology;  ///< sorted by group
  std::vector<BoundaryEvent> boundary;  ///< sorted by group
  /// Numbers below the first group that touches the boundary, and for each of these groups at its
  /// scale and in the interval above it.
  struct Count {
    std::uint32_t interval = 0, holes = 0, components = 0, vertices = 0;
    std::uint32_t holes_at = 0, components_at = 0;  ///< at the scale where the interval begins
  };
  std::vector<Count> counts;
};

/// The rings of the boundary, in no order, from `interval` on; `component` and `hole` are features.
struct RingsFrom {
  std::uint32_t interval = 0;
  std::vector<BoundaryRing> rings;
};

/// The features that each sub-edge of an interval bounds, on its right and on its left.
struct FeaturesFrom {
  std::uint32_t interval = 0;
  std::vector<std::uint32_t> sub_edges, holes, components;
};

/// Exact. O(g b) for g groups that are not quiet and touch a boundary of b sub-edges. A hole that
/// splits goes on as its largest part; where holes merge the oldest goes on, and the outside is
/// older than any; new names are given in the order of the places. `rings` and `features`: called
/// for the first state; then the one for each state after a boundary event, the other after each
/// group that is not quiet. `counts` has the latter only.
TopologyTimeline topology_timeline(const BoundaryHistory& history,
                                   const std::function<void(RingsFrom)>& rings = {},
                                   const std::function<void(FeaturesFrom)>& features = {});

}  // namespace minkref::inline plane
