// The boundary by winding numbers, for the full convolution (Behar & Lien 2012, Sec. 3, after
// Wein).
#pragma once

#include <memory>

#include "reference/plane/dynamic/gap_status.hpp"
#include "reference/plane/dynamic/swept_edge.hpp"

namespace minkref::inline plane {

/// Keeps the winding numbers on both sides of each gap. The faces beside a stretch that has
/// positive length at an event's scale keep their numbers across the event, unless a parallel edge
/// passes over the stretch, which changes them by its sign; all numbers beside the edge follow from
/// one of them (WindingHistory). So an event costs integers only, and the first numbers come from
/// the arrangement at one scale. The boundary has 0 on its right and more on its left, if P and Q
/// are simply connected; it lies on edges of strictly convex vertices (docs/scale-index.md, "Law
/// A", which holds for slits too: they lie inside, so no slit at a vertex is first or last). Exact.
/// `swept` must outlive the result.
std::unique_ptr<GapStatus> winding_status(const PolygonSet& P, const PolygonSet& Q,
                                          const ArrangementEvents& events, const SweptEdge& swept);

/// For each edge of the full convolution, ordered by edge, the numbers beside its first piece of
/// positive length. Exact. O((N + k) log N).
std::vector<SideNumbers> first_numbers(const PolygonSet& P, const PolygonSet& Q,
                                       const Rational& scale);

}  // namespace minkref::inline plane
