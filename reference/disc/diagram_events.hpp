// Radii at which the boundary of P ⊕ ρD changes: corners of the outer Voronoi diagram of P, and
// places between two features that are nearest to each other (Behar & Lien 2012, Appendix).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/equidistant.hpp"

namespace minkref::inline disc {

/// A place outside of P, as far from three features or more, or right between two.
struct DiagramEvent {
  enum class Kind : std::uint8_t {
    corner,   ///< of the diagram: curves start or stop to be on the boundary
    joint,    ///< where a line goes on as an arc passes another curve
    saddle,   ///< between two features: arcs, or an arc and a line, start to touch
    ridge,    ///< between two that are opposite, where a third is as near: perhaps all between
              ///< parallel edges is reached at once
    maximum,  ///< of the distance from P: a hole ends
  };
  Kind kind;
  bool at_joint = false;                ///< a line goes on as an arc there
  std::vector<std::uint32_t> features;  ///< all that are as near, ascending
  Vector<Interval> at;  ///< in the frame of the curves, and so is the squared radius
  Interval squared_radius;
  std::vector<std::uint32_t> of;  ///< two or three of the features, which tell the place
};

struct DiagramEvents {
  OffsetCurves curves;  ///< of P moved from the origin and multiplied by a power of two
  Point origin;
  Rational factor;
  std::vector<DiagramEvent> events;  ///< by radius, then by features
  std::uint64_t exact_signs = 0;

  /// They hold the place and the radius.
  Vector<Interval> place(const DiagramEvent& event) const;
  Interval radius(const DiagramEvent& event) const;
  /// The place and the squared radius of an event, in roots.
  Equidistant<RootNumber> exact(const DiagramEvent& event) const;
  /// Of the feature of a vertex.
  Point vertex(std::uint32_t feature) const;
};

/// Of a valid polygon set, a point or a segment. Candidates come from doubles; each is proven to be
/// as far from its features and from nothing less, and each part of the diagram is found from both
/// of its sides, with the same ends: else LimitExceeded ("too-near"), since doubles did not tell
/// the places of two events apart. That none is missing is not proven: the envelopes have
/// tolerances (docs/disc.md). O(n log n + k) for k candidates that are compared.
DiagramEvents diagram_events(const PolygonSet& P, const BuildOptions& options = {});

}  // namespace minkref::inline disc
