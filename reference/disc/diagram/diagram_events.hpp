// Radii at which the boundary of P ⊕ ρD changes: corners of the outer Voronoi diagram of P, and
// places between two features at their least distance (Behar & Lien 2012, Appendix).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/diagram/diagram_count.hpp"
#include "reference/disc/diagram/diagram_event.hpp"

namespace minkref::inline disc {

/// The place of an event with three features or more: DiagramEvent::of and the branch.
struct FoundPlace {
  Features of;
  unsigned branch;
};

struct DiagramEvents {
  OffsetCurves curves;  ///< of P moved from the origin and multiplied by a power of two
  Point origin;
  Rational factor;
  BoundaryWalks walks;
  std::vector<HullGap> gaps;         ///< of the convex hull, where the diagram goes on to infinity
  std::vector<DiagramEvent> events;  ///< by radius, then by x, then by y
  std::uint64_t exact_signs = 0;

  /// Encloses an event's place and radius.
  Vector<Interval> place(const DiagramEvent& event) const;
  Interval radius(const DiagramEvent& event) const;
  /// An event's place and squared radius, as roots.
  Equidistant<RootNumber> exact(const DiagramEvent& event) const;
  /// The given feature's vertex.
  Point vertex(std::uint32_t feature) const;
  /// The places that diagram_events takes to prove the list again, quicker than it was found.
  std::vector<FoundPlace> places() const;
};

/// Finds the events of a valid polygon set, a point or a segment. Candidates come from rounded
/// envelopes; each is proven to be equally far from its features, with nothing nearer. A count
/// (DiagramCount, docs/disc.md) tells that no event is missing; if the list does not reach the
/// count, envelopes with more bits follow. Throws LimitExceeded ("too-near") if 1,024 bits do not
/// suffice. O(n log n + k) for k compared candidates.
DiagramEvents diagram_events(const PolygonSet& P, const BuildOptions& options = {});

/// The same, with previously found places as the only candidates. Places deserve no more trust than
/// envelopes: each is proven, and the count tells that none is missing. Throws BadInput
/// ("other-places") if the places do not belong to P. O(n log n).
DiagramEvents diagram_events(const PolygonSet& P, const std::vector<FoundPlace>& places,
                             const BuildOptions& options = {});

}  // namespace minkref::inline disc
