// Regions and rest material as doubles, for pictures.
#pragma once

#include <utility>
#include <vector>

#include "reference/disc/features/disc_closing.hpp"

namespace minkref::inline disc {

/// A line, or an arc counter-clockwise about a centre, from start to end.
struct DrawnStep {
  bool is_arc;
  double x0, y0, x1, y1, cx, cy;
};

/// A closed curve's steps, as nearest doubles.
std::vector<DrawnStep> drawn_outline(const RegionOutlines& outlines, const PartRing& ring,
                                     bool is_hidden);
std::vector<DrawnStep> drawn_rest(const RegionOutlines& outlines, const RestMaterial& rest,
                                  const RestRing& ring);

/// A closing's ring: arcs counter-clockwise, with the closing on the right.
std::vector<DrawnStep> drawn_closing(const RegionOutlines& outlines, const RestMaterial& rest,
                                     const ClosingRing& ring);

/// Converts a point from the frame to P; then to nearest doubles.
RootPoint placed(const RegionOutlines& outlines, const RootPoint& point);
std::pair<double, double> drawn_point(const RegionOutlines& outlines, const RootPoint& point);

}  // namespace minkref::inline disc
