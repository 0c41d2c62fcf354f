// Area and length of P ⊕ ρD at any radius, without the boundary.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/index/disc_index.hpp"
#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// A region between the boundary of P and the diagram lies in front of each half of the diagram.
/// Sums over the regions reached as a whole, and over the regions not reached at all, are kept by
/// radius; a query looks only at the remaining halves, which have a corner.
class IndexMeasures {
 public:
  /// `index` must outlive it. O(n log n).
  explicit IndexMeasures(const DiscIndex& index);

  /// Enclosed, but perhaps not sharply (is_sharp). `at` is the radius's place. O(n) comparisons of
  /// whole numbers, and O(k) for k corners.
  OffsetMeasures at(const DiscIndex::Place& at, const Rational& squared_radius) const;

 private:
  /// A point of the diagram as a half sees it: how far along the half's line, or at which angle
  /// about the half's vertex; and the numbers that give the area up to there.
  struct Seen {
    Interval along;
    Vector<Interval> at;
    Interval radius;
  };
  Seen seen(std::uint32_t half, const Vector<Interval>& at, const Interval& radius) const;
  Seen seen_at_node(std::uint32_t half, bool at_end) const;
  Interval area_between(std::uint32_t half, const Seen& a, const Seen& b) const;

  const DiscIndex& index_;
  std::vector<Vector<Interval>> middles_;      ///< by feature: of the arc about a vertex
  std::vector<Equidistant<Interval>> places_;  ///< of events, with radii that are not squared
  std::vector<std::pair<Seen, Seen>> ends_;    ///< of halves
  Interval area_;                              ///< of P
  std::vector<Interval> reached_;  ///< by gap: areas in front of halves that are reached
  std::vector<Interval> lengths_,
      angles_;  ///< by gap: of what no half that is touched is in front of
};

}  // namespace minkref::inline disc
