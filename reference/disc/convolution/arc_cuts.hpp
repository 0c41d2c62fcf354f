// A disc convolution's curves, cut at common points.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/convolution/arc_curves.hpp"
#include "reference/disc/convolution/arc_nodes.hpp"
#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A part of a span between two different cut points.
struct ArcPiece {
  std::uint32_t span;
  std::uint32_t from, to;    ///< nodes, in the sense of the carrier
  bool has_first, has_last;  ///< whether these are the ends of the span
};

/// Pieces use one node only for each point.
struct CutArcs {
  ArcNodes nodes;
  std::vector<ArcPiece> pieces;
};

/// Cuts the spans at nodes: at all points that two spans share, that is, crossings, touching points
/// and ends. The equations of two curves alone give their common points. Exact. O((n + k) log n)
/// for n spans and k pairs with overlapping boxes; `counts` receives the number of these pairs, and
/// how often roots had to tell.
CutArcs cut_arcs(const ArcCurves& curves, OffsetCounts& counts);

}  // namespace minkref::inline disc
