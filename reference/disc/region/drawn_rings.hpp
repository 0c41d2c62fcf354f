// The boundary of P ⊕ ρD as doubles, for drawings.
#pragma once

#include <vector>

#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// A piece from its start to its end; for an arc also the centre, and the bulge: the tangent of a
/// quarter of the arc's angle.
struct DrawnPiece {
  bool is_arc;
  double x0, y0, x1, y1, cx, cy, bulge;
};
using DrawnRing = std::vector<DrawnPiece>;

/// A drawing's origin, and the factor for lengths.
struct DrawingFrame {
  Point origin{0, 0};
  Rational factor = 1;
};

/// The lower left corner of P's box, and a power of two that brings the longer side of the box, or
/// a larger radius, to about 1.
DrawingFrame drawing_frame(const OffsetRegion& region);

/// Each number is the double nearest to the exact number. Infinite beyond the range of doubles.
DrawnRing drawn_ring(const OffsetRegion& region, const OffsetRing& ring,
                     const DrawingFrame& frame = {});

}  // namespace minkref::inline disc
