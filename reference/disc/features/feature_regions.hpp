// The regions of P's features at a radius, and the alpha-shape (Behar & Lien 2012, Sec. 8.2).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/boundary_parts.hpp"

namespace minkref::inline disc {

/// A connected set of points of the outer medial axis nearer to P than the radius. Its region lies
/// between hidden parts of the boundary of P and the chords at its corners.
struct FeatureRegion {
  std::vector<std::uint32_t> nodes;  ///< of the diagram's graph, ascending: events, reflex ends
  std::vector<PartRing> rings;       ///< of hidden parts; the region is on the right
};

/// The alpha-shape at a radius consists of P and the chords of all points of the axis as near, or
/// nearer: P and the regions. It has the components and holes of the closed sum P ⊕ ρD.
struct FeatureRegions {
  FeatureRadius radius;
  BoundaryParts parts;
  std::vector<FeatureRegion> features;  ///< by their first nodes
  std::size_t components;               ///< of the alpha-shape as a closed set: what touches is one
  std::size_t holes;                    ///< bounded components of its complement
};

/// Finds the features of points nearer to P than a radius, given by its square in coordinates of P;
/// none: infinity. At the radius of an event this is the state just below. Exact, by whole numbers.
/// O(n log n). Throws BadInput ("bad-radius") for a square that is not above 0.
FeatureRegions feature_regions(const DiscIndex& index,
                               const std::optional<Rational>& squared_radius);

/// The vertices, by feature, at which the reflex ends of the graph lie, in the order of the nodes.
std::vector<std::uint32_t> reflex_vertices(const DiscIndex& index);

}  // namespace minkref::inline disc
