// The boundary of a closed regular set as a graph, and its canonical form.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Directed straight edges with the set's interior on their left and its exterior on their right.
/// Edges meet only at points; two edges that leave a point have different directions; points
/// differ. An edge there and back forms a slit, with the interior on both sides; slits make
/// Walks::holes meaningless.
struct BoundaryGraph {
  std::vector<Point> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< from, to
};

/// A boundary graph with points ready for exact signs, which must outlive its use.
struct FilteredBoundary {
  std::vector<const FilteredPoint*> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
};

/// A graph's points, ready, with the graph's edges.
class ReadyBoundary {
 public:
  explicit ReadyBoundary(const BoundaryGraph& graph);
  ReadyBoundary(const ReadyBoundary&) = delete;
  ReadyBoundary& operator=(const ReadyBoundary&) = delete;
  const FilteredBoundary& graph() const { return graph_; }

 private:
  std::vector<FilteredPoint> points_;
  FilteredBoundary graph_;
};

/// A closed walk along the boundary of one connected component of the interior. The interior's
/// wedges pair the edges at a point, so a walk passes a point once for each wedge that it bounds
/// there.
struct Walk {
  std::vector<std::uint32_t> points;
  bool encloses = false;  ///< the outer boundary of its component (else the boundary of holes)
  std::uint32_t component = 0;  ///< components are numbered from 0
};

struct Walks {
  std::vector<Walk> walks;
  std::size_t components = 0;          ///< connected components of the interior
  std::size_t holes = 0;               ///< bounded connected components of the complement
  std::vector<std::uint32_t> walk_of;  ///< the walk of each edge
};

/// All walks, each with its component. Exact. O(n log n + h k) for h walks that enclose nothing and
/// k edges beside their first points.
Walks boundary_walks(const FilteredBoundary& graph);
Walks boundary_walks(const BoundaryGraph& graph);

/// docs/definitions.md, "Canonical form": walks split into simple rings at repeated points,
/// collinear vertices merged, rings rotated and sorted. Exact.
Canonical canonical_form(const FilteredBoundary& graph);
Canonical canonical_form(const BoundaryGraph& graph);

/// The canonical form, and for each edge of the graph the number of the polygon that lies on its
/// left. Exact.
struct CanonicalParts {
  Canonical form;
  std::vector<std::uint32_t> polygon_of;
};
CanonicalParts canonical_parts(const FilteredBoundary& graph);
CanonicalParts canonical_parts(const BoundaryGraph& graph);

}  // namespace minkref::inline plane
