// Closed surfaces that bound a set in space: components, cavities, tunnels.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// A closed surface of faces joined at edges: two faces across an edge are joined if the sector
/// between them belongs to the pairing's side. Fans at a vertex stay separate.
struct Shell {
  std::vector<std::uint32_t> faces;  ///< ascending
  std::uint64_t vertices = 0, edges = 0;
  /// The Euler characteristic: vertices - edges + faces, where a face with h holes counts 1 - h.
  long characteristic = 0;
  bool positive = true;  ///< the volume that it bounds, its faces seen from outside, is

  long genus() const { return (2 - characteristic) / 2; }
};

/// All shells, in the order of their first faces. Positive shells of the interior match the
/// interior's connected components, one each; the other shells bound what lies within a component.
/// Negative shells of the outside match the complement's bounded components, one each.
///
/// Proof. A shell has a small motion into its side that makes it an embedded surface: edges and
/// faces move off each other; fans at a vertex have their tips cut off, larger ones closer to the
/// vertex, each capped on the side away from the sector region whose border it is. Let C be a
/// component of the interior. The moved shells about C bound a compact connected manifold, which is
/// C but for a collar and for what lies between the caps. Each moved shell separates space, and
/// each component of a connected manifold's complement has one shell as border (Alexander duality);
/// one component is unbounded. So exactly one shell about C has C on its bounded side, and it alone
/// bounds a positive volume. The same holds of a bounded component of the complement, with the
/// signs reversed; all shells about the unbounded component are positive, since each shell's other
/// side is bounded.
///
/// Exact. O(n log n). Throws std::logic_error if a shell is not orientable or bounds nothing.
std::vector<Shell> shells(const SurfaceEdges& surface, Pairing pairing);

struct SpaceTopology {
  std::uint64_t components = 0;  ///< of the interior
  std::uint64_t cavities = 0;    ///< bounded components of the complement
  std::uint64_t tunnels = 0;     ///< the sum of the genera of the shells of the interior
  friend bool operator==(const SpaceTopology&, const SpaceTopology&) = default;
};
SpaceTopology topology(const SurfaceEdges& surface);

/// A face's area seen along the plane's viewing axis. Exact.
Rational seen_area(const SurfaceEdges& surface, std::uint32_t face);
/// The signed volume that a shell bounds. Exact. The result may be long: its denominator can be the
/// product of all corners' denominators.
Rational volume(const SurfaceEdges& surface, const Shell& shell);

}  // namespace minkref::inline space
