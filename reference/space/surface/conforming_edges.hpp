// Plane regions' borders in space, cut where they meet.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// Two points by number; a segment has the lesser number first.
using PointPair = std::pair<std::uint32_t, std::uint32_t>;

/// Segments contain no inner point: two segments are equal or meet at common ends only.
struct ConformingEdges {
  std::vector<SpaceVertex> points;  ///< distinct, ascending
  std::vector<PointPair> segments;  ///< the edges, each once, ascending
  /// By region: the border, with the region on the left as seen along the viewing axis.
  std::vector<std::vector<PointPair>> borders;
  /// By region: the inner segments, on which other faces stand.
  std::vector<std::vector<PointPair>> slits;
  /// By region: the inner points that end no slit, where a tip touches the region.
  std::vector<std::vector<std::uint32_t>> tips;
};

/// Makes the borders conform. Regions with canonical form do not share their neighbours' vertices:
/// a straight place has none. Nor does the place where one region's border crosses another's, as
/// where a wedge stands on a plane and juts out. So all borders are cut where they meet, and
/// assigned to the regions whose inside contains them; hidden_edges are added. Exact. O((n + k) log
/// n + m) for k pairs of edges and m pairs of an edge and a polygon with overlapping boxes, times
/// the polygon's vertices if the edge lies within the polygon's plane; beside the cost of
/// hidden_edges.
ConformingEdges conforming_edges(const PolyhedralSet& set);

}  // namespace minkref::inline space
