// The boundary of P ⊕ ρD in doubles, for drawings.
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

/// Where a drawing has its origin, and by what it multiplies lengths.
struct DrawingFrame {
  Point origin{0, 0};
  Rational factor = 1;
};

/// The lower left corner of P's box, and a power of two with which the longer side of the box, or
/// the radius where it is larger, is about 1.
DrawingFrame drawing_frame(const OffsetRegion& region);

/// Each number is the double nearest to the exact one. An infinity beyond the range of doubles.
DrawnRing drawn_ring(const OffsetRegion& region, const OffsetRing& ring,
                     const DrawingFrame& frame = {});

}  // namespace minkref::inline disc
