// The boundary of the swept sum {(x, s) : x in sP + Q}: the exposed parts of convolution edges'
// patches.
#pragma once

#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/kept_edges.hpp"
#include "reference/plane/index/patch_node_name.hpp"
#include "reference/plane/moving/moving_edge.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// A piece of an edge's patch, between two nodes and two scales, without a point of the interiors'
/// sum. The sum lies on the edge's left; the edge's right lies outside, or another piece runs the
/// other way.
struct ExposedPiece {
  std::uint32_t edge = 0;
  NodeName from, to;              ///< along the edge
  Rational lower;                 ///< 0: down to scale 0
  std::optional<Rational> upper;  ///< none: up to infinity
};

/// Two edges that meet at one scale only, where ends of both coincide.
struct EndContact {
  std::uint32_t edge = 0, other = 0;
  Rational scale;
};

struct SweptBoundary {
  ScaleWindow window;
  std::vector<ConvolutionEdge> edges;                 ///< of the reduced convolution, S-edges first
  std::vector<RationalEdge> moving;                   ///< the same as functions of the scale
  std::vector<ExposedPiece> pieces;                   ///< sorted by edge
  std::vector<EndContact> contacts;                   ///< of edges with a piece, in no order
  std::uint64_t meeting_pairs = 0, pairs_inside = 0;  ///< see PatchNeighbours
  std::uint64_t pieces_in_all = 0, faces_tested = 0;
  std::vector<char> live;                             ///< edges not wholly inside the sum, surely
  std::uint64_t edges_kept = 0, pairs_looked_at = 0;  ///< of edges that were there before
};

/// A swept boundary of other operands, to start from; `edges` and `moving` may be empty there.
struct SweptBefore {
  Convolved operands;
  const SweptBoundary& boundary;
};

/// The boundary within a window, open towards 0 or infinity without a bound. Exact, and the same
/// for any number of threads. Operands must have passed `validate`. Throws BadInput ("bad-window"),
/// LimitExceeded ("memory-limit"). O(N^2) doubles for N convolution edges at worst, where most of
/// their boxes meet (patch_neighbours.hpp); the further cost depends on the remaining pairs.
///
/// `before`: a boundary within the same window. Kept edges (kept_edges.hpp) keep their pieces;
/// pairs, patches and tests concern the remaining edges only.
SweptBoundary swept_boundary(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                             const BuildOptions& options = {}, const SweptBefore* before = nullptr);

}  // namespace minkref::inline plane
