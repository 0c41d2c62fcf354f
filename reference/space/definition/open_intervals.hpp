// Segments, and what the interiors of convex bodies leave of them.
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

/// Where a convex polygon meets a plane that it does not lie in: a segment, a point, or nothing.
std::optional<CornerSegment> crossing(const CornerRing& ring, const CuttingPlane& plane);

/// Keeps what lies in the closed body; false where that is nothing. Exact.
bool clip(CornerSegment& segment, const SumBody& body);

/// The parts of a segment that are in the interior of no body: segments and points, in order.
/// Exact.
std::vector<CornerSegment> left_open(const CornerSegment& segment,
                                     const std::vector<SumBody>& bodies,
                                     const std::vector<std::uint32_t>& among);

/// A segment, not a point, cut where it enters or leaves bodies. Exact.
std::vector<CornerSegment> cut_at_bodies(const CornerSegment& segment,
                                         const std::vector<SumBody>& bodies,
                                         const std::vector<std::uint32_t>& among);

SolidCorner middle_of(const CornerSegment& segment);
/// Primitive, from the smaller end to the other, as points are ordered.
IntegerVector direction_of(const CornerSegment& segment);

}  // namespace minkref::inline space
