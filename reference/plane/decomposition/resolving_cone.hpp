// Directions in which a cut resolves a notch, and what of a wall lies in them.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {

/// A wall seen from one of its ends: the other end, and whether the sector counter-clockwise next
/// to the wall belongs to the interior.
struct WallRay {
  FilteredPoint to;
  bool interior_after = false;
};

/// The closed cone between the prolongations, beyond `apex`, of two walls. Both walls bound a
/// sector of the interior of more than half a turn, counter-clockwise from `first` to `second`. A
/// cut leaves no such sector iff its direction lies in the cone. The cone lies in the open sector
/// but for its apex, and has less than half a turn.
class ResolvingCone {
 public:
  ResolvingCone(const FilteredPoint& apex, const FilteredPoint& first, const FilteredPoint& second)
      : apex_(apex), first_(first), second_(second) {}

  const FilteredPoint& apex() const { return apex_; }
  const FilteredPoint& first() const { return first_; }
  const FilteredPoint& second() const { return second_; }

  /// The part of a wall in the cone has a nearest point to the apex; nothing where no point of the
  /// wall lies in the cone. The wall does not hold the apex. Exact. O(1).
  std::optional<Point> nearest(const FilteredPoint& from, const FilteredPoint& to) const;

 private:
  FilteredPoint apex_, first_, second_;
};

/// The cone at a point between walls; nothing where no sector of the interior has more than half a
/// turn. There is at most one such sector. Exact. O(k^2) for k walls at the point.
std::optional<ResolvingCone> resolving_cone(const FilteredPoint& at,
                                            const std::vector<WallRay>& walls);

}  // namespace minkref::inline plane
