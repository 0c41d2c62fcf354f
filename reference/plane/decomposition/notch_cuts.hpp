// Cuts of a polygon set from its notches, one after another.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline plane {

/// A cut: an open segment in the interior of P that meets no earlier cut.
struct NotchCut {
  Point from, to;
  std::uint32_t notch = 0;  ///< index among the notches; `from` is its place
  std::uint32_t wall = 0;   ///< an edge of the boundary, or their number + an earlier cut's index
};

struct NotchCuts {
  BoundaryGraph boundary;  ///< of P, its edges cut where rings touch
  std::vector<NotchCut> cuts;
};

/// Walls are the boundary of P and all earlier cuts. At each notch in turn, if a sector of the
/// interior between walls has more than half a turn: the shortest segment from there to a wall in
/// the closed cone between the prolongations of the sector's two walls. As short: the one with the
/// lexicographically least end. Such a segment meets no wall before its end, since that wall would
/// be nearer; a cut leaves no sector of more than half a turn at its notch. Without such a sector,
/// no cut. P is valid; without an interior it has no notches. All ends are rational: each lies on
/// two lines through vertices of P, in the direction of an edge or between two vertices, or turned
/// from such a one by a quarter. Throws BadInput ("no-notch") for a notch that is no vertex of P. Exact. O((n + k)
/// log n) for n vertices and k candidates.
NotchCuts notch_cuts(const PolygonSet& P, const std::vector<Point>& notches);

/// All vertices of P at which the interior has a sector of more than half a turn, in lexicographic
/// order. Exact. O(n log n).
std::vector<Point> reflex_vertices(const PolygonSet& P);

}  // namespace minkref::inline plane
