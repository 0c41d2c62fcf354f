// The directions of cuts that resolve a notch, as a cone; nearest points of walls in the cone.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {

/// A wall seen from an end: the other end, and whether the sector counter-clockwise next to the
/// wall belongs to the interior.
struct WallRay {
  FilteredPoint to;
  bool interior_after = false;
};

/// The closed cone between the prolongations, beyond `apex`, of two walls around a sector of the
/// interior with more than half a turn, counter-clockwise from `first` to `second`. Exactly the
/// cuts along the cone leave no such sector. The cone has less than half a turn; the open sector
/// contains all but the apex.
class ResolvingCone {
 public:
  ResolvingCone(const FilteredPoint& apex, const FilteredPoint& first, const FilteredPoint& second)
      : apex_(apex), first_(first), second_(second) {}

  const FilteredPoint& apex() const { return apex_; }
  const FilteredPoint& first() const { return first_; }
  const FilteredPoint& second() const { return second_; }

  /// The point nearest to the apex on a wall's part in the cone; nothing if the wall misses the
  /// cone. The wall must not contain the apex. Exact. O(1).
  std::optional<Point> nearest(const FilteredPoint& from, const FilteredPoint& to) const;

  /// A double not above the squared distance to that point; infinite if the wall misses the cone.
  /// By intervals, and by exact signs. O(1).
  double squared_bound(const FilteredPoint& from, const FilteredPoint& to) const;

 private:
  struct Sides;
  std::optional<Sides> sides(const FilteredPoint& from, const FilteredPoint& to) const;

  FilteredPoint apex_, first_, second_;
};

/// The cone at a point between walls; nothing if no sector of the interior has more than half a
/// turn (at most one has). Exact. O(k^2) for k walls at the point.
std::optional<ResolvingCone> resolving_cone(const FilteredPoint& at,
                                            const std::vector<WallRay>& walls);

}  // namespace minkref::inline plane
