// Sums with a disc for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/region/drawn_rings.hpp"
#include "reference/disc/region/inset_region.hpp"
#include "reference/disc/region/measure_terms.hpp"
#include "reference/disc/region/offset_passages.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct TimedOffset {
  OffsetRegion region;
  double seconds;
  bool inward = false;
};

std::string json_of(const TimedOffset& offset) {
  return offset.inward ? inset_json(offset.region) : canonical_json(offset.region);
}

OffsetMeasures measures_of(const TimedOffset& offset) {
  return offset.inward ? inset_measures(offset.region) : measures(offset.region);
}

/// A piece with doubles: its start and end; an arc also has its centre and its bulge.
using PieceRow = std::tuple<std::string, double, double, double, double, double, double, double>;
using RingRow = std::vector<PieceRow>;

RingRow ring_row(const OffsetRegion& region, const OffsetRing& ring, const DrawingFrame& frame) {
  RingRow found;
  for (const DrawnPiece& piece : drawn_ring(region, ring, frame)) {
    found.emplace_back(piece.is_arc ? "arc" : "line", piece.x0, piece.y0, piece.x1, piece.y1,
                       piece.cx, piece.cy, piece.bulge);
  }
  return found;
}

std::vector<std::vector<RingRow>> rows_of_rings(const TimedOffset& offset, const ExactPoint& origin,
                                                const std::string& factor) {
  const DrawingFrame frame{{parse_rational(origin.first), parse_rational(origin.second)},
                           parse_rational(factor)};
  std::vector<std::vector<RingRow>> found;
  for (const OffsetComponent& component : offset.region.components) {
    auto& rings = found.emplace_back();
    rings.push_back(ring_row(offset.region, component.outer, frame));
    for (const OffsetRing& hole : component.holes) {
      rings.push_back(ring_row(offset.region, hole, frame));
    }
  }
  return found;
}

std::size_t curves(const TimedOffset& offset) {
  std::size_t count = 0;
  for (const OffsetComponent& component : offset.region.components) {
    count += component.outer.curves.size();
    for (const OffsetRing& hole : component.holes) count += hole.curves.size();
  }
  return count;
}

TimedOffset timed_offset(const Set& P, const std::string& squared_radius, unsigned threads,
                         const std::string& route) {
  const Rational square = parse_rational(squared_radius);
  const OffsetRoute chosen = offset_route_named(route);
  const Stopwatch watch;
  OffsetRegion region = offset_region(P.value, square, build_on(threads), chosen);
  return {std::move(region), watch.seconds()};
}

TimedOffset timed_inset(const Set& P, const std::string& squared_radius, unsigned threads,
                        const std::string& route) {
  const Rational square = parse_rational(squared_radius);
  const OffsetRoute chosen = offset_route_named(route);
  const Stopwatch watch;
  OffsetRegion region = inset_region(P.value, square, build_on(threads), chosen);
  return {std::move(region), watch.seconds(), true};
}

using TextOfCurve = std::vector<std::string>;
using TextOfPoint = std::pair<std::string, std::string>;

TextOfPoint text_of_point(const RootPoint& x) { return {expression(x.x), expression(x.y)}; }

TextOfCurve text_of_curve(const OffsetRegion& region, std::uint32_t feature) {
  const OffsetCurve curve = offset_curve(region.offset.at->curves(), feature, region.origin);
  TextOfCurve text{curve.is_arc ? "arc" : "line", to_string(curve.x), to_string(curve.y)};
  if (!curve.is_arc) text.push_back(to_string(curve.c));
  return text;
}

/// Points, as expressions and rounded; curves at equal distance.
using PassageRow = std::tuple<std::vector<TextOfPoint>, std::vector<std::pair<double, double>>,
                              std::vector<TextOfCurve>>;

std::vector<PassageRow> passages_with_disc(const TimedOffset& offset, unsigned threads) {
  const PatchesAt& at = *offset.region.offset.at;
  std::vector<PassageRow> rows;
  const RootPoint origin = numbers<RootNumber>(offset.region.origin);
  for (const OffsetPassage& passage : offset_passages(at, build_on(threads))) {
    auto& [points, rounded, contacts] = rows.emplace_back();
    for (const RootPoint& from_origin : passage.points) {
      const RootPoint x = from_origin + origin;
      points.push_back(text_of_point(x));
      rounded.emplace_back(nearest_double(x.x), nearest_double(x.y));
    }
    for (const std::uint32_t feature : passage.contacts) {
      contacts.push_back(text_of_curve(offset.region, feature));
    }
  }
  return rows;
}

/// Factors for products of roots, for the length and the area. Arc directions.
using TermRows = std::map<std::string, std::string>;
using AngleRows = std::vector<std::pair<TextOfPoint, TextOfPoint>>;

TermRows term_rows(const RootTerms& terms) {
  TermRows rows;
  for (const auto& [product, factor] : terms.terms()) rows[product] = to_string(factor);
  return rows;
}

std::tuple<TermRows, TermRows, AngleRows> exact_measures(const TimedOffset& offset) {
  const MeasureTerms terms = measure_terms(offset.region);
  AngleRows angles;
  for (const TermAngle& angle : terms.angles) {
    angles.emplace_back(text_of_point(angle.from), text_of_point(angle.to));
  }
  return {term_rows(terms.length), term_rows(terms.area), std::move(angles)};
}

std::pair<double, double> bounds(const Interval& value) { return {value.lower(), value.upper()}; }

Fields statistics(const TimedOffset& offset) {
  const OffsetCounts& counted = offset.region.offset.counts;
  Fields fields;
  MINKREF_PUT(counted, pairs, exact_pairs, exact_orders);
  return fields;
}

}  // namespace

void bind_disc(nb::module_& module) {
  unchanging(nb::class_<TimedOffset>(module, "Offset",
                                     "P + a disc: a region bounded by segments and arcs. Equal to "
                                     "another where the canonical forms are."))
      .def(
          "__eq__",
          [](const TimedOffset& a, const TimedOffset& b) { return json_of(a) == json_of(b); },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"), Released())
      .def(
          "__hash__",
          [](const TimedOffset& offset) { return std::hash<std::string>()(json_of(offset)); },
          Released())
      .def("__repr__",
           [](const TimedOffset& offset) {
             return "<Offset: " + std::to_string(offset.region.components.size()) +
                    " components, " + std::to_string(offset.region.holes) + " holes, " +
                    std::to_string(curves(offset)) + " curves>";
           })
      .def_prop_ro("components",
                   [](const TimedOffset& offset) { return offset.region.components.size(); })
      .def_prop_ro("holes", [](const TimedOffset& offset) { return offset.region.holes; })
      .def_prop_ro("curves", curves, "Of all rings, parts of one circle or line together.")
      .def_prop_ro(
          "area", [](const TimedOffset& offset) { return bounds(measures_of(offset).area); },
          Released(), "Between the two doubles next to it.")
      .def_prop_ro(
          "length", [](const TimedOffset& offset) { return bounds(measures_of(offset).length); },
          Released(), "Of the boundary, between the two doubles next to it.")
      .def_ro("seconds", &TimedOffset::seconds, "Of the computation, without conversions.")
      .def_prop_ro("statistics", statistics,
                   "Curves and edges that were compared, by the route paper curves and curves; how "
                   "often roots had to, and orders that roots had to tell.")
      .def("canonical_json", json_of, Released(), "The canonical form, in rational numbers.")
      .def("tight_passages", passages_with_disc, "threads"_a = 1, Released(),
           "Points and segments that the sum of the interiors misses: (points, the same rounded, "
           "curves that are as far). Exact, as expressions.")
      .def("exact_measures", exact_measures, Released(),
           "Length and area without angles, as factors by products of roots, and the angles: from "
           "a direction counter-clockwise to another, of equal ones a whole turn. The radius times "
           "the sum of the angles is to be added to the length, half of its square times that sum "
           "to the area.")
      .def(
          "drawing_frame",
          [](const TimedOffset& offset) {
            const DrawingFrame frame = drawing_frame(offset.region);
            const Rational square =
                offset.region.offset.at->squared_radius() * frame.factor * frame.factor;
            return std::tuple(to_strings(frame.origin), to_string(frame.factor),
                              nearest_double(root_of(RootNumber(square))));
          },
          Released(),
          "An origin and a factor for drawings, exact: in that frame the boundary is of a size of "
          "about 1. The radius there, in a double.")
      .def("drawn_rings", rows_of_rings, "origin"_a = ExactPoint("0", "0"), "factor"_a = "1",
           Released(),
           "For drawing: of each component its rings, the outer one first; of each its pieces, "
           "(kind, x and y of the start, of the end, of an arc's centre, its bulge), measured from "
           "a point and multiplied by a factor. Each is the nearest double.");
  module.def("offset", timed_offset, "P"_a, "squared_radius"_a, "threads"_a = 1,
             "route"_a = "definition", Released(),
             "P + a disc about the origin, exact. Routes: definition, paper. Raises BadInput.");
  module.def("inset", timed_inset, "P"_a, "squared_radius"_a, "threads"_a = 1,
             "route"_a = "definition", Released(),
             "P less a disc about the origin, exact: rings with the set on their right; the tight "
             "passages are its remnants. Routes: definition, paper. Raises BadInput.");
}

}  // namespace minkref::python
