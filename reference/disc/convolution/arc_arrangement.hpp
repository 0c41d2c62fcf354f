// The arrangement of a disc convolution's curves: neighbours along cycles and about nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/convolution/arc_cuts.hpp"

namespace minkref::inline disc {

/// Pieces as half-edges: 2 k runs as piece k does, 2 k + 1 back. A cycle is a closed walk along
/// half-edges with one face on the left.
class ArcArrangement {
 public:
  /// `curves` must outlive the arrangement. Around each node the pieces are ordered by leaving
  /// direction and, for equal directions, by bend. Exact. O((n + k) log n).
  explicit ArcArrangement(const ArcCurves& curves, OffsetCounts& counts);

  const ArcCurves& curves() const { return curves_; }
  const ArcNodes& nodes() const { return arcs_.nodes; }
  const std::vector<ArcPiece>& pieces() const { return arcs_.pieces; }
  const ArcSpan& span(std::uint32_t half_edge) const {
    return curves_.spans[arcs_.pieces[half_edge / 2].span];
  }
  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * arcs_.pieces.size()); }
  std::uint32_t source(std::uint32_t half_edge) const {
    const ArcPiece& piece = arcs_.pieces[half_edge / 2];
    return half_edge % 2 == 0 ? piece.from : piece.to;
  }

  /// The next half-edge clockwise about the source node.
  std::uint32_t clockwise(std::uint32_t half_edge) const { return clockwise_[half_edge]; }
  /// On along its cycle.
  std::uint32_t next(std::uint32_t half_edge) const { return clockwise_[half_edge ^ 1U]; }
  std::uint32_t cycle(std::uint32_t half_edge) const { return cycles_[half_edge]; }
  std::uint32_t cycles() const { return cycle_count_; }

 private:
  void sort_about_nodes(OffsetCounts& counts);
  void find_cycles();

  const ArcCurves& curves_;
  CutArcs arcs_;
  std::vector<std::uint32_t> clockwise_, cycles_;
  std::uint32_t cycle_count_ = 0;
};

}  // namespace minkref::inline disc
