// The tracks that bound an exposed piece.
#pragma once

#include "reference/plane/dynamic/node_track.hpp"
#include "reference/scalespace/swept_boundary.hpp"

namespace minkref {

/// Where a node of a piece is, as a function of the scale. Exact.
Track track_of(const SweptBoundary& boundary, std::uint32_t edge, const NodeName& node);

}  // namespace minkref
