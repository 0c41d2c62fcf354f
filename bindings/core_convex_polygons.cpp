#include "bindings/core_convex_polygons.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <string>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/plane_scale.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/plane/convex/dynamic_polygon_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

PlaneScaling scaling_of(const std::string& scale) {
  if (const auto axes = axes_of(scale)) return *axes;
  const Rational factor = parse_rational(scale);
  return {factor, factor};
}

Fields update(DynamicPolygonSum& sum, const std::string& scale) {
  const PlaneScaling to = scaling_of(scale);
  const Stopwatch watch;
  const PolygonUpdateCounts counts = computed([&] { return sum.update(to); });
  const double seconds = watch.seconds();
  Fields fields;
  MINKREF_PUT(counts, ev_errors, ve_errors, descent_steps);
  fields["seconds"] = seconds;
  return fields;
}

/// Convex operands have no tight passages.
TimedSum timed_sum(const DynamicPolygonSum& sum) {
  const Stopwatch watch;
  PolygonSet region = sum.region();
  const double seconds = watch.seconds();
  Statistics statistics;
  statistics.kernel = "rational";
  const auto none = [] { return std::vector<TightPassage>{}; };
  return {{std::move(region), true}, 1, 0, seconds, std::move(statistics), LaterPassages(none)};
}

}  // namespace

void bind_convex_polygons(nb::module_& module) {
  nb::class_<DynamicPolygonSum>(
      module, "DynamicPolygonSum",
      "S P + Q of convex polygons kept up to date (Behar & Lien 2012, Sec. 6, in the plane).")
      .def(
          "__init__",
          [](DynamicPolygonSum* self, const Set& P, const Set& Q, const std::string& scale) {
            const PlaneScaling at = scaling_of(scale);
            const Computing computing;
            new (self) DynamicPolygonSum(P.value, Q.value, at);
          },
          "P"_a, "Q"_a, "scale"_a)
      .def("update", &update, "scale"_a,
           "Mends the pairs that the new scaling makes wrong: what was found and walked, and "
           "seconds.")
      .def("sum", &timed_sum, Released(), "The sum in canonical form.")
      .def(
          "pairs",
          [](const DynamicPolygonSum& self) {
            return std::pair(self.vertex_of_Q(), self.vertex_of_P());
          },
          Released(),
          "For each edge of P its vertex of Q, and for each edge of Q its vertex of P; vertices "
          "are strictly convex ones, from the least one on.");
}

}  // namespace minkref::python
