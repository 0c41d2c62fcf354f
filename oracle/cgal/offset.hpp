// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's exact offset of a polygon with holes, by conics.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// A piece of a boundary, as CGAL gives it: monotone along x. Its conic is
/// r x² + s y² + t xy + u x + v y + w = 0, of a line the square of one or of a pair of lines.
struct ConicPiece {
  bool is_arc;
  std::array<mpq_class, 6> conic;
  std::array<double, 4> ends;  ///< rounded: where it starts and ends along the ring
};

using ConicRing = std::vector<ConicPiece>;

struct ConicPolygon {
  ConicRing outer;
  std::vector<ConicRing> holes;
};

/// The offsets of all polygons by a radius, joined.
std::vector<ConicPolygon> offset_of(const std::vector<Polygon>& polygons, const mpq_class& radius);

/// How many curves CGAL's approximated offset has, whose lines are off by the tolerance at most.
std::size_t curves_of_offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                  double tolerance);

}  // namespace minkref::cgal_oracle
