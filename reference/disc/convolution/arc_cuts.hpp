// The curves of a convolution with a disc, cut where they meet.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/convolution/arc_curves.hpp"
#include "reference/disc/convolution/arc_nodes.hpp"
#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A part of a span between two points at which it meets others, which are different.
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

/// All points that two spans share are nodes: crossings, points in which they touch, and ends. All
/// are found from the equations of the two curves alone. Exact. O((n + k) log n) for n spans and k
/// pairs of them with boxes that overlap; `counts` says how many these are, and how often roots had
/// to tell.
CutArcs cut_arcs(const ArcCurves& curves, OffsetCounts& counts);

}  // namespace minkref::inline disc
