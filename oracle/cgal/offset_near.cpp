// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "oracle/cgal/offset.hpp"

namespace minkref::cgal_oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring2 = CGAL::Polygon_2<Kernel>;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;

Ring2 kernel_ring(const Ring& ring, CGAL::Orientation wanted) {
  Ring2 found;
  for (const Point& p : ring) found.push_back({Kernel::FT(p.x), Kernel::FT(p.y)});
  if (found.orientation() != wanted) found.reverse_orientation();
  return found;
}

std::vector<Traits::Polygon_with_holes_2> joined_near(const std::vector<Polygon>& polygons,
                                                      const mpq_class& radius, double tolerance) {
  CGAL::General_polygon_set_2<Traits> all;
  for (const Polygon& polygon : polygons) {
    CGAL::Polygon_with_holes_2<Kernel> operand(kernel_ring(polygon.outer, CGAL::COUNTERCLOCKWISE));
    for (const Ring& hole : polygon.holes) operand.add_hole(kernel_ring(hole, CGAL::CLOCKWISE));
    all.join(CGAL::approximated_offset_2(operand, Kernel::FT(radius), tolerance));
  }
  std::vector<Traits::Polygon_with_holes_2> joined;
  all.polygons_with_holes(std::back_inserter(joined));
  return joined;
}

/// Points on an arc after its start, in the direction of travel, with its end.
void add_arc(const Traits::X_monotone_curve_2& arc, double tolerance, NearRing& ring) {
  const auto& circle = arc.supporting_circle();
  const double x = CGAL::to_double(circle.center().x()), y = CGAL::to_double(circle.center().y());
  const double radius = std::sqrt(CGAL::to_double(circle.squared_radius()));
  const auto angle = [&](const auto& p) {
    return std::atan2(CGAL::to_double(p.y()) - y, CGAL::to_double(p.x()) - x);
  };
  const double first = angle(arc.source());
  double turn = angle(arc.target()) - first;
  if (arc.orientation() == CGAL::COUNTERCLOCKWISE && turn < 0) turn += 2 * CGAL_PI;
  if (arc.orientation() == CGAL::CLOCKWISE && turn > 0) turn -= 2 * CGAL_PI;
  const double step = 2 * std::acos(std::max(1 - tolerance / radius, 0.0));
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
  for (int k = 1; k < steps; ++k) {
    const double at = first + turn * k / steps;
    ring.push_back({x + radius * std::cos(at), y + radius * std::sin(at)});
  }
  ring.push_back({CGAL::to_double(arc.target().x()), CGAL::to_double(arc.target().y())});
}

NearRing near_ring(const Traits::Polygon_2& from, double tolerance) {
  NearRing ring;
  for (auto curve = from.curves_begin(); curve != from.curves_end(); ++curve) {
    if (curve->is_circular()) {
      add_arc(*curve, tolerance, ring);
    } else {
      ring.push_back({CGAL::to_double(curve->target().x()), CGAL::to_double(curve->target().y())});
    }
  }
  return ring;
}

std::size_t curves_of(const Traits::Polygon_2& ring) {
  return static_cast<std::size_t>(std::distance(ring.curves_begin(), ring.curves_end()));
}

}  // namespace

std::vector<NearPolygon> offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                     double tolerance) {
  std::vector<NearPolygon> found;
  for (const auto& polygon : joined_near(polygons, radius, tolerance)) {
    NearPolygon& near = found.emplace_back();
    near.outer = near_ring(polygon.outer_boundary(), tolerance);
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
      near.holes.push_back(near_ring(*hole, tolerance));
    }
  }
  return found;
}

std::string cgal_version_of_offset() { return CGAL_VERSION_STR; }

std::size_t curves_of_offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                  double tolerance) {
  std::size_t curves = 0;
  for (const auto& polygon : joined_near(polygons, radius, tolerance)) {
    curves += curves_of(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
      curves += curves_of(*hole);
    }
  }
  return curves;
}

}  // namespace minkref::cgal_oracle
