// The static sum in Python.
#include <nanobind/stl/string.h>

#include <chrono>

#include "python/core.hpp"
#include "reference/error.hpp"
#include "reference/plane/sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct TimedSum {
  Set region;
  std::size_t components = 0, holes = 0;
  double seconds = 0;
  Statistics statistics;
};

Route route_named(const std::string& name) {
  if (name == "paper") return Route::paper;
  if (name == "winding") return Route::winding;
  if (name == "definition") return Route::definition;
  throw BadInput("unknown-route", "there is no route \"" + name + "\"",
                 "choose paper, winding or definition");
}

TimedSum timed_sum(const Set& P, const Set& Q, const std::string& scale, const std::string& route,
                   const std::string& arithmetic) {
  const Rational s = parse_rational(scale);
  const Route way = route_named(route);
  const auto start = std::chrono::steady_clock::now();
  Sum sum = minkowski_sum(P.value, Q.value, s, way, arithmetic);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  // Only exact arithmetic is known to give a canonical form.
  const bool canonical = arithmetic == "rational" || arithmetic == "interval";
  return {{std::move(sum.region), canonical},
          sum.components,
          sum.holes,
          seconds.count(),
          std::move(sum.statistics)};
}

Fields statistics(const TimedSum& sum) {
  const Statistics& counted = sum.statistics;
  Fields fields;
  fields["by_float"] = counted.by_float;
  fields["by_integer"] = counted.by_integer;
  fields["by_rational"] = counted.by_rational;
  fields["kernel"] = counted.kernel;
  fields["s_edges"] = counted.s_edges;
  fields["t_edges"] = counted.t_edges;
  fields["nodes"] = counted.nodes;
  fields["faces"] = counted.faces;
  fields["orientable_faces"] = counted.orientable_faces;
  return fields;
}

}  // namespace

void bind_sum(nb::module_& module) {
  nb::class_<TimedSum>(module, "Sum", "sP + Q in canonical form, and how it was got.")
      .def_ro("region", &TimedSum::region)
      .def_ro("components", &TimedSum::components)
      .def_ro("holes", &TimedSum::holes)
      .def_ro("seconds", &TimedSum::seconds, "Of the computation, without conversions.")
      .def_prop_ro("statistics", statistics);
  module.def("minkowski_sum", timed_sum, "P"_a, "Q"_a, "scale"_a, "route"_a = "paper",
             "arithmetic"_a = "rational", nb::call_guard<nb::gil_scoped_release>(),
             "sP + Q. Routes: paper, winding, definition. Arithmetics: rational, interval, double, "
             "mpfr:BITS. Raises BadInput, UndecidedSign.");
}

}  // namespace minkref::python
