// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/offset.hpp"

#include <CGAL/Arr_conic_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_traits_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/offset_polygon_2.h>

#include <iterator>

namespace minkref::cgal_oracle {
namespace {

using NumberTraits = CGAL::CORE_algebraic_number_traits;
using Rational = NumberTraits::Rational;
using RationalKernel = CGAL::Cartesian<Rational>;
using AlgebraicKernel = CGAL::Cartesian<NumberTraits::Algebraic>;
using ConicTraits = CGAL::Arr_conic_traits_2<RationalKernel, AlgebraicKernel, NumberTraits>;
using SetTraits = CGAL::Gps_traits_2<ConicTraits>;
using ConicSet = CGAL::General_polygon_set_2<SetTraits>;
using RationalRing = CGAL::Polygon_2<RationalKernel>;

Rational number(const mpq_class& value) {
  return Rational(CORE::BigInt(value.get_num().get_str()), CORE::BigInt(value.get_den().get_str()));
}

mpq_class number(const NumberTraits::Integer& value) { return mpq_class(value.get_str(), 10); }

RationalRing ring_of(const Ring& ring, CGAL::Orientation wanted) {
  RationalRing found;
  for (const Point& p : ring) found.push_back({number(p.x), number(p.y)});
  if (found.orientation() != wanted) found.reverse_orientation();
  return found;
}

ConicRing pieces_of(const SetTraits::Polygon_2& ring) {
  ConicRing found;
  for (auto curve = ring.curves_begin(); curve != ring.curves_end(); ++curve) {
    ConicPiece piece;
    piece.is_arc = curve->orientation() != CGAL::COLLINEAR;
    piece.conic = {number(curve->r()), number(curve->s()), number(curve->t()),
                   number(curve->u()), number(curve->v()), number(curve->w())};
    piece.ends = {CGAL::to_double(curve->source().x()), CGAL::to_double(curve->source().y()),
                  CGAL::to_double(curve->target().x()), CGAL::to_double(curve->target().y())};
    found.push_back(std::move(piece));
  }
  return found;
}

}  // namespace

std::vector<ConicPolygon> offset_of(const std::vector<Polygon>& polygons, const mpq_class& radius) {
  const ConicTraits traits;
  ConicSet all;
  for (const Polygon& polygon : polygons) {
    CGAL::Polygon_with_holes_2<RationalKernel> operand(
        ring_of(polygon.outer, CGAL::COUNTERCLOCKWISE));
    for (const Ring& hole : polygon.holes) operand.add_hole(ring_of(hole, CGAL::CLOCKWISE));
    all.join(CGAL::offset_polygon_2(operand, number(radius), traits));
  }
  std::vector<SetTraits::Polygon_with_holes_2> joined;
  all.polygons_with_holes(std::back_inserter(joined));
  std::vector<ConicPolygon> found;
  for (const auto& polygon : joined) {
    ConicPolygon& own = found.emplace_back();
    own.outer = pieces_of(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
      own.holes.push_back(pieces_of(*hole));
    }
  }
  return found;
}

}  // namespace minkref::cgal_oracle
