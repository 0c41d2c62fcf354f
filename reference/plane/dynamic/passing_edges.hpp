// Parallel edges passing over each other at a single scale.
#pragma once

#include <utility>

#include "reference/plane/dynamic/winding_history.hpp"
#include "reference/plane/moving/moving_edge.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Whether f, on the line of e at this scale, runs along a point of e. Exact.
bool runs_along(const RationalEdge& e, const RationalEdge& f, const Point& point,
                const Rational& scale);

/// The changes of the winding numbers beside e, where f passes over e: from below to the scale of
/// the event, and from there to above. `sign`: f's sign. Exact.
std::pair<SideNumbers, SideNumbers> change_by_passing(const RationalEdge& e, const RationalEdge& f,
                                                      int sign);

}  // namespace minkref::inline plane
