// The connected components of a set and of its complement, from the set's boundary.
#pragma once

#include "reference/plane/history/boundary_history.hpp"

namespace minkref::inline plane {

/// Links of a state without duplicates, and which region each bounds on either side.
struct BoundaryRegions {
  std::vector<BoundaryLink> links;
  std::vector<std::uint32_t> place;      ///< among `links`, of each link that there was
  std::vector<std::uint32_t> hole;       ///< on the right of each link: 0 is outside, then 1, ...
  std::vector<std::uint32_t> component;  ///< on the left: 0, 1, ...
  std::uint32_t holes = 0, components = 0;
  std::vector<std::uint32_t> pinches;  ///< points that the boundary passes more than once
  BoundaryCycles walks;                ///< links as walks along the components
  /// Vertices in canonical form: (vertex, next vertex) of each straight boundary edge, sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
};

/// `scale`: any scale at which the state holds; needed only for several components. Exact. O(n);
/// with several components O(n c) exact comparisons for c cycles.
BoundaryRegions boundary_regions(const std::vector<Track>& tracks, BoundaryState state,
                                 CycleFinder& finder, const Rational& scale);

/// The component around an interior point. Exact. O(n).
std::uint32_t component_around(const std::vector<Track>& tracks, const BoundaryRegions& regions,
                               const Point& point, const Rational& scale);

/// A simple ring of the canonical form, as vertices.
struct BoundaryRing {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> edges;  ///< of the convolution, behind each vertex
  bool is_hole = false;              ///< clockwise
  std::uint32_t component = 0;       ///< that it bounds, as in BoundaryRegions
  std::uint32_t hole = 0;            ///< on its other side; 0 is the outside
};

/// The rings of the canonical form (docs/definitions.md), in no order: walks split at repeated
/// points, vertices with no turn left out. Exact. O(n).
std::vector<BoundaryRing> boundary_rings(const BoundaryRegions& regions, const CycleFinder& finder);

}  // namespace minkref::inline plane
