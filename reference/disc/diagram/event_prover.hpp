// Exact proofs that a place is an event of the outer Voronoi diagram.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "reference/disc/diagram/diagram_event.hpp"
#include "reference/disc/diagram/edge_lookup.hpp"

namespace minkref::inline disc {

/// Looks at one candidate after the other. Decides by intervals of doubles, then by intervals
/// around the exact numbers, then by the exact numbers.
class EventProver {
 public:
  /// `lookup` must outlive it.
  explicit EventProver(const EdgeLookup& lookup) : lookup_(lookup), curves_(lookup.curves()) {}

  /// The places that two or three features single out, sharp enough for a search of further
  /// features nearby; ordered like the exact places, which DiagramEvent::branch counts.
  std::vector<Equidistant<Interval>> places(const Features& features) const;

  /// The event at one of the places. Empty if a feature is nearer, if P lies all around, or if one
  /// feature does not count: a vertex inside an edge, or a vertex where an edge goes straight on as
  /// the next.
  std::optional<DiagramEvent> event(const Features& features, unsigned branch,
                                    const Equidistant<Interval>& place);

  /// Whether two events share one place. Both have the same features.
  bool are_one(const DiagramEvent& a, const DiagramEvent& b) const;

  std::uint64_t exact_signs = 0;

 private:
  const Equidistant<RootNumber>& exact(const DiagramEvent& event);
  template <class InIntervals, class Exact>
  int sign_of(DiagramEvent& event, InIntervals&& in_intervals, Exact&& by_roots);
  bool add(std::uint32_t number, DiagramEvent& event, std::set<std::uint32_t>& found);
  int distance_order(const Point& from, DiagramEvent& event);
  int height_order(std::uint32_t number, DiagramEvent& event);
  bool is_in_front(std::uint32_t number, DiagramEvent& event);
  bool is_outside(DiagramEvent& event);
  DiagramEvent::Kind kind_of(DiagramEvent& event);
  template <class N>
  Vector<N> way(std::uint32_t feature, const Vector<N>& from) const;

  const EdgeLookup& lookup_;
  const OffsetCurves& curves_;
  // State for the candidate under test.
  std::set<std::uint32_t> straight_here_;
  std::vector<std::uint32_t> met_inside_;  ///< edges
  std::map<std::uint32_t, std::uint32_t> edge_of_line_;
  std::optional<Equidistant<RootNumber>> exact_;
};

}  // namespace minkref::inline disc
