// Tight passages in space: points that the sum covers and the sum of the interiors misses.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The closure of int(S P ⊕ Q) less ri S P ⊕ ri Q (docs/definitions.md, "Tight passages").
struct TightPassagesInSpace {
  /// Regions in one plane each; the normal's first nonzero coordinate is positive. Planes ascend.
  std::vector<PlaneRegion> sheets;
  /// Maximal segments that lie in no sheet, each with the smaller end first, ascending.
  std::vector<std::pair<SpacePoint, SpacePoint>> lines;
  /// Points in neither, ascending.
  std::vector<SpacePoint> points;
  bool empty() const { return sheets.empty() && lines.empty() && points.empty(); }
  friend bool operator==(const TightPassagesInSpace&, const TightPassagesInSpace&) = default;
};

/// `{"lines":[[["x","y","z"],["x","y","z"]],...],"points":[["x","y","z"],...],"sheets":[...]}`, the
/// sheets as the planes of a polyhedral set.
std::string canonical_json(const TightPassagesInSpace& passages);

/// Finds the passages between valid operands that do not cross themselves; one operand may be thin.
/// Complete and exact (docs/space-sums.md, "Tight passages"). Throws like summed_pieces, with
/// `most_pairs_for_passages`. For k bodies with f facets, n others near each: O(k f² n) segments at
/// worst, each against n bodies; a facet that one other body covers costs only this check.
TightPassagesInSpace tight_passages_in_space(const Polyhedron& P, const Polyhedron& Q,
                                             const Scaling& scaling);

constexpr std::size_t most_pairs_for_passages = 4'096;

}  // namespace minkref::inline space
