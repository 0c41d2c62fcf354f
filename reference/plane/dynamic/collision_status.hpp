// The boundary by collision detection, for the reduced convolution (Behar & Lien 2012, Sec. 3).
#pragma once

#include <memory>

#include "reference/plane/dynamic/gap_status.hpp"
#include "reference/plane/dynamic/swept_edge.hpp"

namespace minkref::inline plane {

/// A sub-edge that goes on across an event (with positive length at the event's scale) keeps its
/// status: collision detection runs once for each sub-edge born with length zero. `swept` must
/// outlive the result.
std::unique_ptr<GapStatus> collision_status(const PolygonSet& P, const PolygonSet& Q,
                                            const ArrangementEvents& events,
                                            const SweptEdge& swept);

}  // namespace minkref::inline plane
