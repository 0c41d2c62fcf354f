// Radii at which the boundary of P ⊕ ρD changes: corners of the outer Voronoi diagram of P, and
// places between two features that are nearest to each other (Behar & Lien 2012, Appendix).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/diagram/diagram_count.hpp"
#include "reference/disc/diagram/diagram_event.hpp"

namespace minkref::inline disc {

/// Where an event with three features or more was found: DiagramEvent::of and its branch.
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

  /// Enclosures of the place and the radius of an event.
  Vector<Interval> place(const DiagramEvent& event) const;
  Interval radius(const DiagramEvent& event) const;
  /// The place and the squared radius of an event, in roots.
  Equidistant<RootNumber> exact(const DiagramEvent& event) const;
  /// The vertex with that feature.
  Point vertex(std::uint32_t feature) const;
  /// The places that diagram_events takes to prove the list again, quicker than it was found.
  std::vector<FoundPlace> places() const;
};

/// Finds the events of a valid polygon set, a point or a segment. Candidates come from rounded
/// envelopes; each is proven to be equally far from its features, with nothing nearer. A count
/// (DiagramCount, docs/disc.md) tells that none is missing; where the count is not reached,
/// envelopes of more bits are looked at. Throws LimitExceeded ("too-near") where 1,024 bits do not
/// suffice. O(n log n + k) for k candidates that are compared.
DiagramEvents diagram_events(const PolygonSet& P, const BuildOptions& options = {});

/// The same, with places that were found before as candidates, and no others. They are trusted no
/// more than an envelope is: each is proven, and the count tells that none is missing. Throws
/// BadInput ("other-places") where they are not those of P. O(n log n).
DiagramEvents diagram_events(const PolygonSet& P, const std::vector<FoundPlace>& places,
                             const BuildOptions& options = {});

}  // namespace minkref::inline disc
