// The boundary of the swept sum {(x, s) : x in sP + Q}: where the patches of convolution edges are
// exposed.
#pragma once

#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/patch_node_name.hpp"
#include "reference/plane/moving/moving_edge.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// A piece of the patch of an edge, between two nodes and two scales, in which no point is in the
/// sum of the interiors. The sum is on the left of the edge; on its right it is not, or another
/// piece runs the other way.
struct ExposedPiece {
  std::uint32_t edge = 0;
  NodeName from, to;              ///< along the edge
  Rational lower;                 ///< 0: down to scale 0
  std::optional<Rational> upper;  ///< none: up to infinity
};

/// Two edges that meet at one scale only, in an end of both.
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
};

/// Within a window, open towards 0 or infinity where a bound is none. Exact, and the same for any
/// number of threads. Operands must have passed `validate`. Throws BadInput ("bad-window"),
/// LimitExceeded
/// ("memory-limit"). O(N^2)
/// in doubles for N edges of the convolution; what follows depends on the pairs that are left.
SweptBoundary swept_boundary(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                             const BuildOptions& options = {});

}  // namespace minkref::inline plane
