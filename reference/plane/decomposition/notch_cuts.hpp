// Cuts a polygon set at notches, step by step.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline plane {

/// A cut: an open segment in the interior of P that meets no earlier cut.
struct NotchCut {
  Point from, to;
  std::uint32_t notch = 0;  ///< index of the notch at `from`
  std::uint32_t wall = 0;   ///< a boundary edge, or the number of edges + an earlier cut's index
};

struct NotchCuts {
  BoundaryGraph boundary;  ///< P's boundary, edges divided where rings touch
  std::vector<NotchCut> cuts;
};

/// Cuts P at each notch in turn. Walls: the boundary of P and all earlier cuts. If a sector of the
/// interior between walls has more than half a turn, cuts along the shortest segment to a wall in
/// the closed cone between the prolongations of the sector's two walls; among equally short
/// segments, to the lexicographically least end. Otherwise makes no cut. A cut meets no wall before
/// its end: a nearer wall would have been taken. P must be valid; a set without interior has no
/// notches. Each end lies on two lines through vertices of P that have the direction from vertex to
/// vertex, perhaps turned by a quarter: so all numbers stay rational and short. Throws BadInput
/// ("no-notch") for a notch that is no vertex of P. Exact. O((n + k) log n) for n vertices and k
/// candidates.
NotchCuts notch_cuts(const PolygonSet& P, const std::vector<Point>& notches);

/// All vertices of P where the interior has a sector with more than half a turn, in lexicographic
/// order. Exact. O(n log n).
std::vector<Point> reflex_vertices(const PolygonSet& P);

}  // namespace minkref::inline plane
