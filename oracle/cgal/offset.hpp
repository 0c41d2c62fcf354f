// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's exact offset, with conics, of a polygon with holes.
#pragma once

#include <gmpxx.h>

#include <array>
#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// CGAL's boundary piece, monotone along x. Its conic is r x² + s y² + t xy + u x + v y + w = 0;
/// for a line, the square of a line or a pair of lines.
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

/// Joins the offsets of all polygons by a radius.
std::vector<ConicPolygon> offset_of(const std::vector<Polygon>& polygons, const mpq_class& radius);

using NearRing = std::vector<std::array<double, 2>>;

struct NearPolygon {
  NearRing outer;
  std::vector<NearRing> holes;
};

/// Joins CGAL's approximated offsets of all polygons. CGAL moves lines by at most the tolerance;
/// the polygons given for its arcs are off by as much again, and by the rounding of doubles.
std::vector<NearPolygon> offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                     double tolerance);

std::string cgal_version_of_offset();

/// Counts the curves of CGAL's approximated offset, whose lines deviate by at most the tolerance.
std::size_t curves_of_offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                  double tolerance);

}  // namespace minkref::cgal_oracle
