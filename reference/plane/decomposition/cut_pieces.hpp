// Pieces between the cuts.
#pragma once

#include <utility>
#include <vector>

#include "reference/plane/decomposition/notch_cuts.hpp"

namespace minkref::inline plane {

/// The closure of a connected component when cuts are taken from the interior.
struct CutPiece {
  PolygonSet region;                           ///< one polygon, in canonical form
  std::vector<std::pair<Point, Point>> slits;  ///< parts of cuts with this piece on both sides
};

/// All pieces, sorted by outer ring as the canonical form sorts polygons; slits follow the cuts'
/// order. Pieces tile P, at most as many as cuts and components of the interior together. Exact.
/// O(n log n + h k) as boundary_walks, for n vertices and ends of cuts.
std::vector<CutPiece> cut_pieces(const NotchCuts& cuts);

}  // namespace minkref::inline plane
