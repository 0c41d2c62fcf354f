// PolygonSet in Python.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/core_shapes.hpp"
#include "bindings/exact_number.hpp"
#include "bindings/plane_scale.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/json_text.hpp"
#include "formats/read_json.hpp"
#include "formats/refusal_place.hpp"
#include "formats/write.hpp"
#include "reference/error.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/convex/convex_ring.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/point_predicates.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using DrawnRing = std::vector<std::pair<double, double>>;

DrawnRing drawn(const Ring& ring) {
  DrawnRing points;
  points.reserve(ring.size());
  for (const auto& point : ring)
    points.emplace_back(finite_double(point.x), finite_double(point.y));
  return points;
}

std::vector<std::vector<DrawnRing>> drawn_rings(const Set& set) {
  std::vector<std::vector<DrawnRing>> polygons;
  for (const auto& polygon : set.value.polygons) {
    auto& rings = polygons.emplace_back();
    rings.push_back(drawn(polygon.outer));
    for (const auto& hole : polygon.holes) rings.push_back(drawn(hole));
  }
  return polygons;
}

std::tuple<double, double, double, double> bounding_box(const Set& set) {
  const auto& polygons = set.value.polygons;
  if (polygons.empty() || polygons[0].outer.empty()) {
    throw std::invalid_argument("the empty set has no bounding box");
  }
  Point low = polygons[0].outer[0], high = low;
  for (const auto& polygon : polygons) {
    for (const auto& point : polygon.outer) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  return {finite_double(low.x), finite_double(low.y), finite_double(high.x), finite_double(high.y)};
}

std::string canonical_text(const Set& set) {
  return canonical_json(set.canonical ? set.value : canonicalize(set.value).region);
}

/// Equal for equal sets of points: a canonical form has no points and segments.
std::string compared_text(const Set& set) {
  if (set.value.empty() || has_area(set.value)) return canonical_text(set);
  return canonical_json(lines_of(joined(segments_of(set.value))));
}

Location location(const Set& set, const nb::object& point) {
  const Set read = set_of_shape(point, false);
  if (!read.value.is_point()) {
    throw BadInput("no-point", "this is not a point", "give a point (x, y)");
  }
  return computed([&] { return locate(set.value, read.value.polygons[0].outer[0]); });
}

/// The result of a function of Python for two sets.
nb::object of_two(const char* function, nb::handle P, nb::handle Q) {
  return nb::module_::import_("minkref.plane.erosion").attr(function)(P, Q);
}

/// The rings as written: no ring is turned or validated.
Set set_of(const std::string& text, const ReadLimits& limits) {
  Input input("", limits);
  const JsonText document(text, input);
  SetBuilder builder(input);
  read_json_set(document.root(), builder, JsonNumbers::any);
  Reading reading = builder.finish_as_read();
  return {std::move(reading.set), false, std::move(reading.origins)};
}

Set from_json(const std::string& text) { return set_of(text, ReadLimits{}); }

std::string to_json(const Set& set) {
  std::string text = write(set.value, Format::json);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// Reads our own text, numbers of any length. The rings' places within a file are lost.
Set from_state(const std::pair<std::string, bool>& state) {
  return {set_of(state.first, no_limits()).value, state.second};
}

void bind_kinds(nb::class_<Set>&& bound) {
  bound
      .def_prop_ro(
          "is_region", [](const Set& set) { return has_area(set.value); }, Released(),
          "A set with an area: not empty, no points and segments.")
      .def_prop_ro(
          "is_convex", [](const Set& set) { return is_convex(set.value); }, Released(),
          "One convex polygon without holes; straight vertices may be there.")
      .def_prop_ro("is_empty", [](const Set& set) { return set.value.empty(); })
      .def_prop_ro("is_point", [](const Set& set) { return set.value.is_point(); })
      .def_prop_ro("is_segment", [](const Set& set) { return set.value.is_segment(); })
      .def_prop_ro(
          "is_lines", [](const Set& set) { return is_lines(set.value); }, Released(),
          "Several points and segments.");
}

void bind_questions(nb::class_<Set>&& bound) {
  bound
      .def(
          "__add__",
          [](nb::handle_t<Set> P, nb::handle_t<Set> Q) { return of_two("sum_of", P, Q); },
          nb::is_operator(), nb::sig("def __add__(self, other: PolygonSet, /) -> PolygonSet"),
          "The Minkowski sum of both sets, as minkowski_sum gives it.")
      .def(
          "__sub__",
          [](nb::handle_t<Set> P, nb::handle_t<Set> Q) { return of_two("erosion_of", P, Q); },
          nb::is_operator(), nb::sig("def __sub__(self, other: PolygonSet, /) -> typing.Any"),
          "The erosion of the first set by the second one, as minkref.erode gives it. (The "
          "difference of two sets is minkref.subtract.)")
      .def(
          "__contains__",
          [](const Set& set, const nb::object& point) {
            return location(set, point) != Location::outside;
          },
          "point"_a, nb::sig("def __contains__(self, point: object, /) -> bool"),
          "Whether the closed set has a point (x, y). Exact. O(n).")
      .def(
          "locate",
          [](const Set& set, const nb::object& point) { return word_of(location(set, point)); },
          "point"_a, "Where a point (x, y) lies: inside, boundary or outside. Exact. O(n).")
      .def_prop_ro(
          "written_rings",
          [](const Set& set) {
            std::vector<std::pair<std::size_t, std::vector<std::size_t>>> rings;
            for (const RingOrigin& origin : set.origins) {
              std::vector<std::size_t> lines(origin.lines.begin(), origin.lines.end());
              rings.emplace_back(origin.ring, std::move(lines));
            }
            return rings;
          },
          "The number of each ring in the file, with the line of each vertex in the file's order; "
          "empty for sets of no file.");
}

}  // namespace

std::string word_of(Location location) {
  if (location == Location::boundary) return "boundary";
  return location == Location::inside ? "inside" : "outside";
}

/// Sizes, kinds, and the set under a scaling or a translation.
static void bind_measures(nb::class_<Set>&& bound) {
  bound
      .def("bounding_box", bounding_box, Released(),
           "xmin, ymin, xmax, ymax: the nearest doubles. Raises as arrays(); ValueError for the "
           "empty set.")
      .def_prop_ro(
          "area",
          [](const Set& set) { return quantity(computed([&] { return area(set.value); })); },
          nb::sig("def area(self) -> fractions.Fraction"), "The exact area. Linear.")
      .def(
          "scaled",
          [](const Set& set, const std::string& factor) {
            const auto axes = axes_of(factor);
            return Set{axes ? scaled(set.value, *axes) : scaled(set.value, parse_rational(factor))};
          },
          "factor"_a, Released(),
          nb::sig("def scaled(self, factor: " MINKREF_NUMBER
                  " | collections.abc.Sequence[" MINKREF_NUMBER "]) -> PolygonSet"),
          "About the origin; by \"SX,SY\" or [SX, SY] with a factor above 0 for each axis.")
      .def(
          "translated",
          [](const Set& set, const std::string& x, const std::string& y) {
            return Set{translated(set.value, {parse_rational(x), parse_rational(y)})};
          },
          "x"_a, "y"_a, Released(),
          nb::sig("def translated(self, x: " MINKREF_NUMBER ", y: " MINKREF_NUMBER
                  ") -> PolygonSet"))
      .def_prop_ro("vertices", [](const Set& set) { return set.value.vertices(); })
      .def_prop_ro("ring_count", [](const Set& set) { return set.value.rings(); });
}

void bind_polygon_set(nb::module_& module) {
  unchanging(nb::class_<Set>(
                 module, "PolygonSet",
                 "A closed regular set bounded by polygons; exact. A value: never changed, equal "
                 "to each set of the same points."))
      .def(
          "__init__",
          [](Set* self, const nb::object& shape, bool validate) {
            new (self) Set(set_of_shape(shape, validate));
          },
          "shape"_a.none() = nb::make_tuple(), nb::kw_only(), "validate"_a = true,
          nb::sig("def __init__(self, shape: object = (), *, validate: bool = True) -> None"),
          "From one point (x, y), a ring of points, a polygon (its outer ring, then its holes), "
          "a list of polygons, GeoJSON, an object with __geo_interface__ (Shapely), WKT, or a "
          "set; without one, the empty set. Numbers count by their exact value: int, Fraction, "
          "Decimal, float (0.1 is the double next to a tenth), scalars and arrays of NumPy, texts "
          "('0.1', '7/5'). Rings are turned as they should run; a sequence of points is a ring, "
          "whose first point may be repeated at its end. Raises BadInput for all else: what is no "
          "shape (None too), what a file of the same would be refused for, as a line of one "
          "point, and what is neither a regular closed set nor points and segments. With "
          "`validate` false the last is not looked at, and no ring is turned. O(n log n) on usual "
          "input.")
      .def(
          "__eq__",
          [](const Set& a, const Set& b) {
            return a.value == b.value || compared_text(a) == compared_text(b);
          },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"), Released())
      .def(
          "__hash__",
          [](const Set& set) { return std::hash<std::string>()(compared_text(set)) >> 1; },
          Released())
      .def("__repr__", [](const Set& set) { return shown(set); })
      .def(
          "_repr_svg_", [](const Set& set) { return write(set.value, Format::svg); }, Released())
      .def_prop_ro(
          "__geo_interface__",
          [](const Set& set) {
            const std::string text = computed([&] { return write(set.value, Format::geojson); });
            return nb::module_::import_("json").attr("loads")(text);
          },
          "GeoJSON's geometry in doubles, as Shapely and others take it.")
      .def_static("from_json", from_json, "text"_a, Released(),
                  "From {\"polygons\":[{\"outer\":ring,\"holes\":[...]}]}; nothing is validated.")
      .def("to_json", to_json, Released(), "The rings as they are stored.")
      .def(
          "__getstate__", [](const Set& set) { return std::pair(to_json(set), set.canonical); },
          Released())
      .def(
          "__setstate__",
          [](Set& self, const std::pair<std::string, bool>& state) {
            new (&self) Set(from_state(state));
          },
          Released())
      .def("canonical_json", canonical_text, Released(), "Canonical JSON of the canonical form.")
      .def(
          "validate",
          [](const Set& set, const std::string& source, bool lines) {
            validate_as_read(set.value, set.origins, source,
                             lines ? Lines::allowed : Lines::refused);
          },
          "source"_a = "", "lines"_a = false, Released(),
          "Raises BadInput unless the set is regular closed, a point or a segment; `lines`: or "
          "several points and segments.")
      .def_ro("warnings", &Set::warnings,
              "What the reader of the file or text put right; empty for all other sets.")
      .def("rings", exact_rings,
           nb::sig("def rings(self) -> list[list[list[tuple[fractions.Fraction, "
                   "fractions.Fraction]]]]"),
           "Exact: per polygon its outer ring, then its holes, points as pairs of Fractions.")
      .def("arrays", arrays_of_doubles, nb::sig("def arrays(self) -> list[list[typing.Any]]"),
           "As rings(), each an array of NumPy of shape (n, 2), of the nearest doubles. Raises "
           "LimitExceeded for a coordinate beyond their range.")
      .def("approximate_rings", drawn_rings, Released(),
           "As rings(), points as pairs of the nearest doubles. Raises as arrays().");
  bind_kinds(nb::borrow<nb::class_<Set>>(module.attr("PolygonSet")));
  bind_measures(nb::borrow<nb::class_<Set>>(module.attr("PolygonSet")));
  bind_questions(nb::borrow<nb::class_<Set>>(module.attr("PolygonSet")));
}

}  // namespace minkref::python
