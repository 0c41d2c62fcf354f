// Whether the sum lies right of a convolution edge where no other edge runs back along it.
#pragma once

#include "reference/plane/moving/interior_test.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// Whether a tight passage may run across a face of the patch of an edge, so that a point of the
/// face is outside of the sum of the interiors although the sum is on both sides of the edge: only
/// if each operand is a segment or has rings that touch (docs/scale-index.md, "Why one point
/// decides a face"). Exact. O(n log n) on usual input.
bool may_hide_passages(const PolygonSet& P, const PolygonSet& Q);

/// Whether the closed sum lies right of an edge at a scale, next to an inner point of the edge.
/// Every edge through the point must lie on the same line. Costs as much as deciding a point.
bool sum_on_the_right(const RationalEdge& edge, const Point& x, const Rational& scale,
                      const InteriorTest& interior);

}  // namespace minkref::inline plane
