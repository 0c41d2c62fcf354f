// The vertical decomposition of a box by the boundary of a set.
#pragma once

#include "certify/plane/cell_complex.hpp"

namespace minkref::certify {

/// An edge to decompose by, from left to right, and whether the set is above it.
struct DecomposingEdge {
  std::uint32_t from = 0, to = 0, line = 0;
  bool inside_above = false;
};

struct Decomposition {
  std::vector<Cell> inside, outside;
};

/// Trapezoids with vertical sides, each a maximal one between two edges. `edges` are not vertical
/// and meet at ends only; `corners` are all their ends, those of vertical edges, and further points
/// through which the sides shall go. Exact. O(n a), a edges being above each other.
Decomposition vertical_decomposition(CellComplex& complex,
                                     const std::vector<DecomposingEdge>& edges,
                                     const std::vector<std::uint32_t>& corners);

}  // namespace minkref::certify
