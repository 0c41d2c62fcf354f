// The pieces into which cuts divide a polygon set.
#pragma once

#include <utility>
#include <vector>

#include "reference/plane/decomposition/notch_cuts.hpp"

namespace minkref::inline plane {

/// The closure of a connected component of the interior without the cuts.
struct CutPiece {
  PolygonSet region;                           ///< one polygon, in canonical form
  std::vector<std::pair<Point, Point>> slits;  ///< parts of cuts with this piece on both sides
};

/// All pieces, by their outer rings in the order of the canonical form; slits in the order of the
/// cuts. Their interiors are disjoint, and their union is P. There are at most as many as cuts and
/// components of the interior of P. Exact. O(n log n + h k) as boundary_walks, for n vertices and
/// ends of cuts.
std::vector<CutPiece> cut_pieces(const NotchCuts& cuts);

}  // namespace minkref::inline plane
