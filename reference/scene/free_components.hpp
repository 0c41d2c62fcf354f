// The free places beside a closed set, and how they hang together.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/motion/valid_scales.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/passages/tight_graph.hpp"

namespace minkref::inline scene {

/// With contact forbidden, a component is a connected component of the closed set's complement, a
/// cell. With contact allowed, cells whose closures touch are one component, and tight passages
/// belong to the cells that they touch; passages that touch no cell form components of their own
/// (docs/scenes.md, "Free components").
struct FreeComponents {
  /// Canonical, in canonical order, behind the cell without bound, which has no outer ring.
  std::vector<Polygon> cells;
  std::vector<std::uint32_t> of_cell;  ///< each cell's component
  /// The component of each edge of the tight passages; empty with contact forbidden.
  std::vector<std::uint32_t> of_passage;
  /// Number 0 has no bound; then by their first cells, at last those of passages alone, by their
  /// least points.
  std::size_t count = 0;
};

/// `boundary`: of the closed set. `passages`: cut wherever they touch the boundary. Exact.
/// O(n log n + h k) for h cells and islands and k edges beside their first points.
FreeComponents free_components(const BoundaryGraph& boundary, const TightGraph& passages,
                               ContactRule rule);

}  // namespace minkref::inline scene
