// Cells of a convolution edge's patch that may touch the boundary, being not surely inside.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/plane/critical/moving_pairs.hpp"
#include "reference/plane/index/interior_solids.hpp"
#include "reference/plane/index/interior_tracks.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

RoundedEdge rounded(const RationalEdge& edge);

/// Scales from `low` to `high`; the part of the edge from `from` to `to`, 0 being its start and 1
/// its end.
struct PatchCell {
  double low = 0, high = 0, from = 0, to = 1;
};

/// The track of a cell's middle, with half its length along the edge, and the cell's whole length
/// at its greatest scale.
std::pair<RoundedTrack, double> middle_of(const RoundedEdge& edge, const PatchCell& cell);

/// The quad of a cell; requires scales other than 0 and infinity.
SweptQuad swept_quad(const RoundedEdge& edge, const PatchCell& cell);

/// A cut of a stretch of scales: about the middle of its logarithms, with a dozen bits.
double cut_between(double low, double high);

/// A patch outside its cells certainly lies inside the interiors' sum.
struct PatchCells {
  std::vector<std::uint32_t> first;  ///< edge e has cells[first[e] .. first[e + 1])
  std::vector<PatchCell> cells;

  std::span<const PatchCell> of(std::uint32_t edge) const {
    return {cells.data() + first[edge], cells.data() + first[edge + 1]};
  }
};

/// The cells between two scales, 0 and infinity allowed. By doubles, with a proof; the same for any
/// number of threads. Some 10 us an edge.
PatchCells patch_cells(const InteriorTracks& tracks, InteriorSolids& solids,
                       const std::vector<RoundedEdge>& edges, double from, double to,
                       const BuildControl& control);

}  // namespace minkref::inline plane
