// The static sum for Python.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_convex_polygons.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_shapes.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/plane_scale.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/plane/route_names.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/thin_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// Points, and for each segment between them the rows of the touching edges.
using PassageRow = std::pair<std::vector<ExactPoint>, std::vector<std::vector<EdgeRow>>>;

std::vector<PassageRow> passage_rows(const std::vector<TightPassage>& passages) {
  std::vector<PassageRow> rows;
  rows.reserve(passages.size());
  for (const TightPassage& passage : passages) {
    auto& [points, contacts] = rows.emplace_back();
    for (const Point& point : passage.points) points.push_back(to_strings(point));
    for (const auto& edges : passage.contacts) contacts.push_back(convolution_rows(edges));
  }
  return rows;
}

TimedSum timed_sum(const Set& P, const Set& Q, const std::string& scale, const std::string& route,
                   const std::string& arithmetic, bool with_passages) {
  const ScaledOperand operand(P.value, scale);
  const Route way = route_named(route);
  if (way == Route::definition) {
    refuse_large_definition(operand.set(), Q.value);
  } else {
    refuse_large_convolution(P.value, Q.value, way == Route::winding);
  }
  const Stopwatch watch;
  Sum sum = minkowski_sum(operand.set(), Q.value, operand.scale(), way, arithmetic,
                          with_passages ? Passages::find : Passages::leave);
  const double seconds = watch.seconds();
  // Only exact arithmetic is known to give a canonical form.
  const bool canonical = arithmetic == "rational" || arithmetic == "interval";
  // The sum keeps its operands alive.
  const auto find = [operand, &Q] {
    return tight_passages(operand.set(), Q.value, operand.scale());
  };
  return {{std::move(sum.region), canonical},
          sum.components,
          sum.holes,
          seconds,
          std::move(sum.statistics),
          LaterPassages(find, std::move(sum.tight_passages))};
}

Fields statistics(const TimedSum& sum) {
  const Statistics& counted = sum.statistics;
  Fields fields;
  MINKREF_PUT(counted, by_float, by_integer, by_rational, kernel, s_edges, t_edges, nodes, faces,
              orientable_faces);
  return fields;
}

}  // namespace

void bind_sum(nb::module_& module) {
  unchanging(nb::class_<TimedSum>(module, "Sum", "sP + Q in canonical form, and how it was got."))
      .def(
          "__reduce_ex__",
          [](const TimedSum&, int) -> nb::object {
            throw nb::type_error("a Sum cannot be pickled; pickle its region, a PolygonSet");
          },
          nb::sig("def __reduce_ex__(self, protocol: typing.SupportsIndex, /) "
                  "-> str | tuple[typing.Any, ...]"))
      .def("__repr__",
           [](const TimedSum& sum) {
             return "<Sum: " + std::to_string(sum.components) + " components, " +
                    std::to_string(sum.holes) + " holes, " +
                    std::to_string(sum.region.value.vertices()) + " vertices>";
           })
      .def_ro("region", &TimedSum::region)
      .def_prop_ro(
          "area",
          [](const TimedSum& sum) {
            return quantity(computed([&] { return area(sum.region.value); }));
          },
          nb::sig("def area(self) -> fractions.Fraction"), "The exact area. Linear.")
      .def_ro("components", &TimedSum::components)
      .def_ro("holes", &TimedSum::holes)
      .def_ro("seconds", &TimedSum::seconds, "Of the computation, without conversions.")
      .def_prop_ro("statistics", statistics)
      .def(
          "passage_rows",
          [](const TimedSum& sum) { return passage_rows(sum.tight_passages.get()); }, Released(),
          "The tight passages as rows: (points, contacts).")
      .def_prop_ro(
          "tight_passages",
          [](const nb::object& sum) {
            const nb::object read =
                nb::module_::import_("minkref.plane.parents").attr("passage_values");
            return read(sum.attr("passage_rows")());
          },
          nb::sig("def tight_passages(self) -> list[dict[str, typing.Any]]"),
          "As minkref.tight_passages gives them, of sP + Q itself, exact whatever arithmetic found "
          "the region. Found when first asked for, in the time of that function, and kept. Raises "
          "BadInput for an answer of the paper's own program.");
  nb::dict routes;
  for (const RouteName& each : route_names()) {
    routes[nb::str(each.name.data(), each.name.size())] =
        nb::str(each.what.data(), each.what.size());
  }
  module.attr("ROUTES") = routes;
  module.def("minkowski_sum", timed_sum, "P"_a, "Q"_a, "scale"_a, "route"_a = "paper",
             "arithmetic"_a = "rational", "tight_passages"_a = false, nb::keep_alive<0, 1>(),
             nb::keep_alive<0, 2>(), Released(),
             "sP + Q; by \"SX,SY\" S P + Q. Routes: paper, winding, definition. Arithmetics: "
             "rational, interval, double, "
             "mpfr:BITS. `tight_passages`: they are found at once, in rational arithmetic from the "
             "same arrangement. Raises BadInput, UndecidedSign.");
  module.def(
      "tight_passages",
      [](const Set& P, const Set& Q, const std::string& scale) {
        const ScaledOperand operand(P.value, scale);
        return passage_rows(tight_passages(operand.set(), Q.value, operand.scale()));
      },
      "P"_a, "Q"_a, "scale"_a, Released(),
      "What the sum of the interiors misses inside of sP + Q: (points, contacts), contacts being "
      "rows as reduced_convolution's for each segment.");
  module.def(
      "sum_remnants",
      [](const Set& P, const Set& Q, const std::string& scale, const Set& region) {
        const ScaledOperand operand(P.value, scale);
        return passage_rows(sum_remnants(operand.set(), Q.value, operand.scale(), region.value));
      },
      "P"_a, "Q"_a, "scale"_a, "region"_a, Released(),
      "What sP + Q has beside its region, for P and Q of points and segments: as tight_passages.");
  bind_convex_polygons(module);
}

}  // namespace minkref::python
