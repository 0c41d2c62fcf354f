// The borders of all plane regions in space, cut where they meet.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// Two points by number; a segment has the lesser number first.
using PointPair = std::pair<std::uint32_t, std::uint32_t>;

/// Segments have no point in their inside: two of them are the same or meet at common ends only.
struct ConformingEdges {
  std::vector<SpaceVertex> points;  ///< distinct, ascending
  std::vector<PointPair> segments;  ///< the edges, each once, ascending
  /// By region: its border, the region on the left as it is seen along the viewing axis.
  std::vector<std::vector<PointPair>> borders;
  /// By region: the segments in its inside, on which other faces stand.
  std::vector<std::vector<PointPair>> slits;
  /// By region: the points in its inside that end no slit, where a tip touches the region.
  std::vector<std::vector<std::uint32_t>> tips;
};

/// Regions in canonical form do not share the vertices of their neighbours: what is straight has
/// none. Nor has a place where the border of one region crosses that of another, as where a wedge
/// stands on a plane and juts out. So all borders are cut where they meet others, and the regions
/// are searched in whose inside they lie; hidden_edges are added. Exact. O((n + k) log n + m) for k
/// pairs of edges and m of edges and polygons whose boxes overlap, times the vertices of the
/// polygon where the edge lies in its plane; beside that of hidden_edges.
ConformingEdges conforming_edges(const PolyhedralSet& set);

}  // namespace minkref::inline space
