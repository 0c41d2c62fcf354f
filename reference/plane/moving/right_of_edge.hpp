// Whether the sum lies on the right of a convolution edge, where no other edge runs back along it.
#pragma once

#include <vector>

#include "reference/plane/moving/interior_test.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// Of a point inside an edge at a scale, in the interior of no other edge there that is not on the
/// same line: whether the face of the arrangement on its right lies in the sum. A point of that
/// face, nearer than any edge in this direction, is decided. Exact. O(edges), and the test of a
/// point.
bool sum_on_the_right(const std::vector<RationalEdge>& edges, std::uint32_t edge, const Point& x,
                      const Rational& scale, const InteriorTest& interior);

}  // namespace minkref::inline plane
