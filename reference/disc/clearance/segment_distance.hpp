// The distance of two closed segments, exact and between doubles.
#pragma once

#include "reference/disc/curves/patch_numbers.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A closed segment from `a` to `b`, which may be equal.
struct ClosedSegment {
  Point a, b;
};

/// Two places at the least distance, each as a fraction of its segment.
struct NearestPlaces {
  Rational squared;  ///< of the distance; 0 if the segments meet
  Rational t, u;
};

/// The nearest places of two segments: of several the least `t`, and for this the least `u`. Exact,
/// in rational numbers. O(1).
NearestPlaces nearest_places(const ClosedSegment& first, const ClosedSegment& second);

/// A segment in doubles.
struct NearSegment {
  Vector<Interval> a, b, along;
  Interval squared_length;

  explicit NearSegment(const ClosedSegment& segment);
};

/// Encloses the squared distance. Certified; a lower bound of 0 may tell nothing.
Interval squared_distance(const NearSegment& first, const NearSegment& second);

}  // namespace minkref::inline disc
