// A sum of the paper's program in space beside the exact one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/paper/space/paper_space_update.hpp"

namespace minkref {

/// How an answer differs from the exact sum at its scale.
struct SpaceSumTrial {
  /// Equal exposed facets, each with equally many rings and corners, no corner beyond the limit.
  bool same_structure = false;
  Rational error = 0;       ///< of the structure: the largest of a corner's coordinate
  Rational coordinate = 0;  ///< the largest of the exact sum, without its sign
  struct Witness {
    SpacePoint point;     ///< on the facet's plane
    OrientedPlane plane;  ///< with the sum below
    bool on_boundary;     ///< exactly; the answer is the contrary
  };
  std::optional<Witness> witness{};  ///< where the structure differs, if a point was found
};

/// Compares an answer from `update` at `scale` with the same operands' exact boundary: `truth` from
/// `facet_sum_at`, `exact` from an exact route. The witness lies inside a cell whose answer `exact`
/// refutes. `limit`: the largest allowed error of a corner, relative to the largest coordinate.
/// O(n) for n cells, times the corners per plane.
SpaceSumTrial space_sum_trial(const PaperSpaceUpdate& update, const Rational& scale,
                              const PaperSpaceSum& answer, const PaperSpaceSum& truth,
                              const PolyhedralSet& exact, const Rational& limit);

/// How the events of an array differ from the exact ones, crossing by crossing.
struct SpaceEventTrial {
  std::uint64_t events = 0;     ///< in truth
  std::uint64_t right = 0;      ///< of these, answered within an ulp
  std::uint64_t misplaced = 0;  ///< answered, and farther off
  std::uint64_t missed = 0;     ///< not answered
  std::uint64_t invented = 0;   ///< answered, not in truth
};

/// `bits`: of the answer's numbers, for the ulp; 0 for exact numbers. O(n log n).
SpaceEventTrial space_event_trial(std::vector<PaperSpaceUpdate::Event> truth,
                                  std::vector<PaperSpaceUpdate::Event> answer, long bits);

}  // namespace minkref
