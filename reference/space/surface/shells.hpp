// The closed surfaces that bound a set in space: components, cavities, tunnels.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// A closed surface of faces joined at edges: two faces across an edge are joined if the sector
/// between them is of the side of the pairing. At a vertex the fans are separate.
struct Shell {
  std::vector<std::uint32_t> faces;  ///< ascending
  std::uint64_t vertices = 0, edges = 0;
  /// The Euler characteristic: vertices - edges + faces, where a face with h holes counts 1 - h.
  long characteristic = 0;
  bool positive = true;  ///< the volume that it bounds, its faces seen from outside, is

  long genus() const { return (2 - characteristic) / 2; }
};

/// All shells, in the order of their first faces. Those of the interior that are positive are one
/// for each connected component of the interior, the others bound what lies within a component.
/// Those of the outside that are negative are one for each bounded component of the complement.
///
/// Proof. A shell has a small motion into its side that makes it an embedded surface: edges and
/// faces move off each other; fans at a vertex have their tips cut off, larger ones closer to the
/// vertex, each capped on the side away from the sector region whose border it is. Let C be a
/// component of the interior. The moved shells about C bound a compact connected manifold, which is
/// C but for a collar and for what lies between the caps. Each of them separates space, and each
/// component of the complement of a connected manifold has one of them as its border (Alexander
/// duality); one of these components is unbounded. So exactly one shell about C has C on its
/// bounded side, and it alone bounds a positive volume. The same holds of a bounded component of
/// the complement, with the signs reversed; all shells about the unbounded one are positive, since
/// in each of them the other side is the bounded one.
///
/// Exact. O(n log n). std::logic_error where a shell is not orientable or bounds nothing.
std::vector<Shell> shells(const SurfaceEdges& surface, Pairing pairing);

struct SpaceTopology {
  std::uint64_t components = 0;  ///< of the interior
  std::uint64_t cavities = 0;    ///< bounded components of the complement
  std::uint64_t tunnels = 0;     ///< the sum of the genera of the shells of the interior
  friend bool operator==(const SpaceTopology&, const SpaceTopology&) = default;
};
SpaceTopology topology(const SurfaceEdges& surface);

/// The area of a face seen along the viewing axis of its plane. Exact.
Rational seen_area(const SurfaceEdges& surface, std::uint32_t face);
/// The volume that a shell bounds, signed. Exact. The result may be long: its denominator can be
/// the product of those of all corners.
Rational volume(const SurfaceEdges& surface, const Shell& shell);

}  // namespace minkref::inline space
