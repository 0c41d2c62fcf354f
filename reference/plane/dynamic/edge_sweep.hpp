// Sweeps the scales along one convolution edge.
#pragma once

#include <memory>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/dynamic/node_arithmetic.hpp"

namespace minkref::inline plane {

/// Positions order the nodes along an edge; they are linear functions of the scale, so the order
/// changes at events only. A sub-edge between two events belongs to the boundary at all scales
/// between them or at none, since the arrangement of the convolution contains the boundary.
/// Collision detection tells which for the reduced convolution (collision_status.hpp), winding
/// numbers for the full convolution (winding_status.hpp).
class EdgeSweep {
 public:
  /// `of`: the convolution that has the events.
  EdgeSweep(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events,
            ConvolutionType of);
  ~EdgeSweep();

  /// Appends to `history`; edges in ascending order. Exact. O(k + e l) for k nodes, e events and
  /// l nodes at a time.
  void sweep(std::uint32_t edge, EdgeHistory& history);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace minkref::inline plane
