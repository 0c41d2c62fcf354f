// The vertical decomposition of a box by a set's boundary.
#pragma once

#include "certify/plane/cell_complex.hpp"

namespace minkref::certify {

/// A decomposing edge, from left to right, and whether the set lies above.
struct DecomposingEdge {
  std::uint32_t from = 0, to = 0, line = 0;
  bool inside_above = false;
};

struct Decomposition {
  std::vector<Cell> inside, outside;
};

/// Trapezoids with vertical sides, each maximal between two edges. `edges` are not vertical and
/// meet at ends only; `corners` are all their ends, the ends of vertical edges, and further points
/// through which sides shall go. Exact. O(n a) for a edges above each other.
Decomposition vertical_decomposition(CellComplex& complex,
                                     const std::vector<DecomposingEdge>& edges,
                                     const std::vector<std::uint32_t>& corners);

}  // namespace minkref::certify
