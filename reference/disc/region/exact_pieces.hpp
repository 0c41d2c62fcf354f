// A boundary's pieces as exact numbers, for output.
#pragma once

#include <vector>

#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// A ring's piece, within the region's frame.
struct ExactPiece {
  const OffsetPatch* patch;  ///< of an arc with its centre
  RootPoint from, to;

  bool is_arc() const { return patch->edge == OffsetPatch::none; }
};

/// The pieces, one after the other. Each corner is found from roots, which takes some hundred
/// microseconds at most.
std::vector<ExactPiece> exact_pieces(const OffsetRegion& region, const OffsetRing& ring);

}  // namespace minkref::inline disc
