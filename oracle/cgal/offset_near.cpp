// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>

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

std::size_t curves_of(const Traits::Polygon_2& ring) {
  return static_cast<std::size_t>(std::distance(ring.curves_begin(), ring.curves_end()));
}

}  // namespace

std::size_t curves_of_offset_near(const std::vector<Polygon>& polygons, const mpq_class& radius,
                                  double tolerance) {
  CGAL::General_polygon_set_2<Traits> all;
  for (const Polygon& polygon : polygons) {
    CGAL::Polygon_with_holes_2<Kernel> operand(kernel_ring(polygon.outer, CGAL::COUNTERCLOCKWISE));
    for (const Ring& hole : polygon.holes) operand.add_hole(kernel_ring(hole, CGAL::CLOCKWISE));
    all.join(CGAL::approximated_offset_2(operand, Kernel::FT(radius), tolerance));
  }
  std::vector<Traits::Polygon_with_holes_2> joined;
  all.polygons_with_holes(std::back_inserter(joined));
  std::size_t curves = 0;
  for (const auto& polygon : joined) {
    curves += curves_of(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
      curves += curves_of(*hole);
    }
  }
  return curves;
}

}  // namespace minkref::cgal_oracle
