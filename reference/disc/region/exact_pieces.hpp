// The pieces of a boundary in exact numbers, for what is written of them.
#pragma once

#include <vector>

#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// A piece of a ring, in the frame of the region.
struct ExactPiece {
  const OffsetPatch* patch;  ///< of an arc with its centre
  RootPoint from, to;

  bool is_arc() const { return patch->edge == OffsetPatch::none; }
};

/// One after the other. Each corner is found in roots, which takes some hundred microseconds at
/// most.
std::vector<ExactPiece> exact_pieces(const OffsetRegion& region, const OffsetRing& ring);

}  // namespace minkref::inline disc
