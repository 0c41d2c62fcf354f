// The convolution of a polygon set with a disc: segments and arcs, with their multiplicities.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/curves/offset_patch.hpp"
#include "reference/disc/curves/patch_numbers.hpp"

namespace minkref::inline disc {

/// A circle or a whole line that curves of the convolution run along.
struct ArcCarrier {
  bool is_circle = false;
  Point centre;  ///< of a circle
  /// The direction of a line in coprime integers: to the right, or straight up.
  Direction way;
  std::uint32_t way_number = 0;  ///< lines that are parallel have one
  /// A line is N · p = level + side ρ |N| with N = (way.y, -way.x). The side is 1 for a line moved
  /// from its edge along N, -1 against N; 0 for rational ρ |N|, which the level then includes.
  Rational level;
  int side = 0;
  Rational squared_reach;  ///< ρ² |N|²
  Rational squared_length;

  // Enclosures. near_point: the centre of a circle, or N of a line; near_reach: ρ |N|.
  Vector<Interval> near_point, near_way;
  Interval near_level, near_reach, near_squared_length;

  Direction normal() const { return {way.y, -way.x}; }
};

/// A place where the boundary of P turns, moved out by the radius: a circle's point along a normal.
/// Named without any computation.
struct ArcJoint {
  std::uint32_t circle;
  Direction normal;  ///< in coprime integers
};

/// A part of a carrier over which the convolution has one multiplicity, not 0: how often the
/// convolution runs along the carrier, forwards (a line along its way, a circle counter-clockwise)
/// less backwards.
struct ArcSpan {
  std::uint32_t carrier;
  std::uint32_t from, to;  ///< joints
  int multiplicity;
  /// The patch of P's offset curves that contains the span and runs the same way; none where no
  /// boundary of the sum can be: along slits and about reflex vertices.
  std::uint32_t patch;
  Rational low, high;     ///< of a line: way · p at its ends
  Direction first, last;  ///< of a circle: its ends, in one quadrant
  int quadrant = 0;

  Interval near_low, near_high;
  Vector<Interval> near_first, near_last;
};

struct ArcCurves {
  Rational squared_radius;
  std::vector<ArcCarrier> carriers;
  std::vector<ArcJoint> joints;
  std::vector<ArcSpan> spans;
};

/// The full convolution of P and the disc (Behar & Lien 2012, Sec. 3 and Appendix): each edge moved
/// out by the radius, an arc about each convex vertex, and about each reflex one the arc the other
/// way round. Slits first join holes to outer rings, so that the winding number at x counts the
/// common parts of P and the disc about x. Overlapping curves form one span, or none if they
/// cancel. Circles are cut at the four axis directions. `offset` holds the offset curves of P.
/// Exact. O(n log n) but for the slits.
ArcCurves arc_curves(const PolygonSet& P, const Rational& squared_radius,
                     const OffsetCurves& offset);

}  // namespace minkref::inline disc
