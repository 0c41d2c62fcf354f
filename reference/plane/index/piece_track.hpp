// The tracks that bound an exposed piece.
#pragma once

#include "reference/plane/index/swept_boundary.hpp"
#include "reference/plane/moving/track.hpp"

namespace minkref::inline plane {

/// A piece node's position as a function of the scale. Exact.
Track track_of(const SweptBoundary& boundary, std::uint32_t edge, const NodeName& node);

}  // namespace minkref::inline plane
