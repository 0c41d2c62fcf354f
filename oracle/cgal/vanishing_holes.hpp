// SPDX-License-Identifier: GPL-3.0-or-later
// The holes that a sum surely fills.
#pragma once

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// P without each hole H whose bounding box is no wider or no higher than the bounding box of Q:
///     width(H) <= width(Q)  or  height(H) <= height(Q).
/// The sum with Q stays the same point set.
///
/// Proof. Let H be the open inside of the hole's ring: a connected component of P's complement,
/// whose boundary belongs to P. A point x lies outside the sum iff P does not meet K = x - Q.
/// Because K is compact and connected, K then lies in a single component of P's complement. This
/// component differs from H: a compact set inside an open set keeps a positive distance from the
/// open set's complement, so K's box lies strictly inside H's box, and width(Q) = width(K) <
/// width(H), and likewise for the heights. Hence K lies in another component, which meets neither H
/// nor its boundary, and x lies outside (P with H filled) + Q. The reverse inclusion is
/// monotonicity. Equality may be used: a Q that fits exactly touches P on both sides, and sums are
/// closed. (A tight passage then remains of H, no part of the point set.) P's holes go one after
/// another, and then Q's holes for the same reason, because P is connected.
///
/// CGAL's own filter (Minkowski_sum_2/Hole_filter_2.h) asks for "<" instead of "<=", on boxes of
/// doubles rounded outwards; CGAL 5.5.1 erases through stale iterators if it finds two holes. After
/// this function CGAL's filter finds nothing, unless rounding reverses a comparison: then CGAL
/// wrongly erases a hole, and this fault of CGAL shall show.
///
/// Exact. O(n).
Polygon without_vanishing_holes(const Polygon& p, const Polygon& q);

}  // namespace minkref::cgal_oracle
