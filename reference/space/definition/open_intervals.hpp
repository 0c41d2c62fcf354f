// Segments, and the parts that convex bodies' interiors leave.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// In the interior. Exact.
bool is_inside(const SolidCorner& corner, const SumBody& body);

/// Closed; perhaps a point.
struct CornerSegment {
  SolidCorner from, to;
  bool is_point() const;
};

/// A convex polygon's meeting with a plane that does not contain the polygon: a segment, a point,
/// or nothing.
std::optional<CornerSegment> crossing(const CornerRing& ring, const CuttingPlane& plane);

/// Keeps the segment's part within the closed body; returns false if nothing remains. Exact.
bool clip(CornerSegment& segment, const SumBody& body);

/// The segment's parts outside every body's interior: segments and points, in order. Exact.
std::vector<CornerSegment> left_open(const CornerSegment& segment,
                                     const std::vector<SumBody>& bodies,
                                     const std::vector<std::uint32_t>& among);

/// Cuts a segment, not a point, where the segment enters or leaves bodies. Exact.
std::vector<CornerSegment> cut_at_bodies(const CornerSegment& segment,
                                         const std::vector<SumBody>& bodies,
                                         const std::vector<std::uint32_t>& among);

SolidCorner middle_of(const CornerSegment& segment);
/// The primitive direction from the smaller end to the other, by the order of points.
IntegerVector direction_of(const CornerSegment& segment);

}  // namespace minkref::inline space
