// SPDX-License-Identifier: GPL-3.0-or-later
// The holes that a sum fills for certain.
#pragma once

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// P without each hole H whose bounding box is no wider or no higher than the bounding box of Q:
///     width(H) <= width(Q)  or  height(H) <= height(Q).
/// The sum with Q stays the same point set.
///
/// Proof. Let H be the open inside of the hole's ring: a connected component of the complement of
/// P, whose boundary belongs to P. A point x lies outside the sum iff P does not meet K = x - Q. K
/// is compact and connected, so it then lies in one component of P's complement. It is not H: a
/// compact set inside an open one keeps a positive distance from its complement, so its box lies
/// strictly inside that of H, and width(Q) = width(K) < width(H), and so for the heights. Hence K
/// lies in another component, which meets neither H nor its boundary, and x is outside (P with H
/// filled) + Q. The other inclusion is monotonicity. Equality may be used: a Q that fits exactly
/// touches P on both sides, and sums are closed. (What is left of H then is a tight passage, no
/// part of the point set.) The holes of P go one after another, and then those of Q by the same
/// argument, P being connected.
///
/// CGAL's own filter (Minkowski_sum_2/Hole_filter_2.h) asks for "<" in place of "<=", on boxes of
/// doubles that are rounded outwards; CGAL 5.5.1 erases through stale iterators where it finds two.
/// After this one it finds nothing, but where the rounding turns a comparison round: a hole that it
/// then erases is lost wrongly, which is a fault of CGAL's and is left to show.
///
/// Exact. O(n).
Polygon without_vanishing_holes(const Polygon& p, const Polygon& q);

}  // namespace minkref::cgal_oracle
