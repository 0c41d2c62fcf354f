// The features' regions at a radius, and the alpha-shape (Behar & Lien 2012, Sec. 8.2).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/boundary_parts.hpp"

namespace minkref::inline disc {

/// Connected points on the outer medial axis, nearer to P than the radius. The region lies between
/// hidden parts and the chords at the feature's corners.
struct FeatureRegion {
  std::vector<std::uint32_t> nodes;  ///< graph nodes, ascending: events, reflex ends
  std::vector<PartRing> rings;       ///< hidden parts, with the region on the right
};

/// The alpha-shape unites P with the chords at all axis points up to the radius, that is, with the
/// regions. Components and holes match the closed sum P ⊕ ρD.
struct FeatureRegions {
  FeatureRadius radius;
  BoundaryParts parts;
  std::vector<FeatureRegion> features;  ///< by their first nodes
  std::size_t components;  ///< the alpha-shape's, as a closed set: touching sets count once
  std::size_t holes;       ///< bounded components around
};

/// Finds all features at a squared radius; none: infinity. At an event's radius: the state just
/// below. Exact: compares whole numbers. O(n log n). Throws BadInput ("bad-radius") for a square
/// not above 0.
FeatureRegions feature_regions(const DiscIndex& index,
                               const std::optional<Rational>& squared_radius);

/// Lists the reflex ends' vertices, as features, ordered like the graph's nodes.
std::vector<std::uint32_t> reflex_vertices(const DiscIndex& index);

}  // namespace minkref::inline disc
