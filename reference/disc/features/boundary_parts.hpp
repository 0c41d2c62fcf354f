// The boundary of P at a radius, cut at the feet of the corners: parts that bound the sum at this
// radius, and hidden parts, behind which features lie.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A radius for features, which consist of points nearer to P than the radius.
struct FeatureRadius {
  std::uint32_t level;              ///< how many radii of events are below
  bool at_event;                    ///< the next radius of an event is this one
  std::optional<Rational> squared;  ///< in the frame of the curves; none: infinite
};

/// Takes a squared radius in coordinates of P, above 0, or none for infinity. Exact.
FeatureRadius feature_radius(const DiscIndex& index, const std::optional<Rational>& squared_radius);

/// From the foot of one corner to the foot of the next corner along a walk.
struct BoundaryPart {
  std::uint32_t walk;
  std::uint32_t from, to;               ///< halves of the diagram that carry the corners
  std::vector<std::uint32_t> vertices;  ///< passed on the way, by feature

  bool operator==(const BoundaryPart&) const = default;
};

/// A closed curve: parts, one after the other, joined by chords between both feet of a corner. No
/// parts: a whole walk.
struct PartRing {
  std::vector<std::uint32_t> parts;
  std::uint32_t walk;
};

struct BoundaryParts {
  std::vector<BoundaryPart> hidden, visible;
  /// Closed curves of hidden parts have features on the right; of visible parts, P and all features
  /// on the left. Whole walks come last.
  std::vector<PartRing> hidden_rings, visible_rings;
};

/// Finds all parts below a level. Exact, by whole numbers. O(n).
BoundaryParts boundary_parts(const DiscIndex& index, std::uint32_t level);

/// The vertices of a whole walk in order, by feature.
std::vector<std::uint32_t> walk_vertices(const DiscIndex& index, std::uint32_t walk);

}  // namespace minkref::inline disc
