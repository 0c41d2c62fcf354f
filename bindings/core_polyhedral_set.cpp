// Binds sums for arbitrary polyhedra.
#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/core_convex.hpp"
#include "bindings/core_polyhedral_state.hpp"
#include "bindings/core_shapes.hpp"
#include "bindings/core_space.hpp"
#include "bindings/core_space_surface.hpp"
#include "bindings/core_sum_surface.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/space/convex/convex_set.hpp"
#include "reference/space/definition/convex_pieces.hpp"
#include "reference/space/definition/definition_sum.hpp"
#include "reference/space/definition/tight_passages.hpp"
#include "reference/space/edges/edge_sum.hpp"
#include "reference/space/point_location.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

std::optional<ConvexBody> convex_body(const PolyhedralSet& set) {
  std::optional<ConvexPolyhedron> found = convex_polyhedron(set);
  if (!found) return std::nullopt;
  return ConvexBody{std::make_shared<const ConvexPolyhedron>(std::move(*found))};
}

Location location(const PolyhedralSet& set, const nb::object& point) {
  const SpacePoint x = to_point(space_point_of(point, "the point"));
  const Computing computing;
  return locate(set, x);
}

void bind_set(nb::class_<PolyhedralSet>& bound) {
  unchanging(nb::class_<PolyhedralSet>(bound))
      .def(
          "__init__",
          [](PolyhedralSet* self, const Surface& surface, const std::string& source) {
            const Computing computing;
            validate_as_read(surface.reading, source);
            new (self) PolyhedralSet(polyhedral_set(surface.value()));
          },
          "surface"_a, "source"_a = "",
          "The set that a polyhedron bounds. Refuses (BadInput) what is not valid. Exact.")
      .def(
          "__eq__", [](const PolyhedralSet& a, const PolyhedralSet& b) { return a == b; },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"), Released())
      .def("__getstate__", &state_of, Released())
      .def(
          "__setstate__",
          [](PolyhedralSet& self, const std::vector<PlaneRow>& state) {
            new (&self) PolyhedralSet(set_of_state(state));
          },
          Released())
      .def(
          "__hash__",
          [](const PolyhedralSet& set) {
            return std::hash<std::string>()(canonical_json(set)) >> 1;
          },
          Released())
      .def("__repr__",
           [](const PolyhedralSet& set) {
             return "<PolyhedralSet: faces in " + std::to_string(set.faces.size()) + " planes>";
           })
      .def(
          "canonical_json", [](const PolyhedralSet& set) { return canonical_json(set); },
          Released(), "The text of which the digest is taken.")
      .def("convex", &convex_body, Released(),
           "The set as a ConvexPolyhedron; None where it is not convex, or empty. Exact.")
      .def(
          "surface",
          [](const PolyhedralSet& set) {
            return SumSurface{std::make_shared<const SurfaceEdges>(surface_edges(set))};
          },
          Released(), "The boundary: facets, meshes, topology. Exact.")
      .def(
          "__contains__",
          [](const PolyhedralSet& set, const nb::object& point) {
            return location(set, point) != Location::outside;
          },
          "point"_a, nb::sig("def __contains__(self, point: object, /) -> bool"),
          "Whether the closed set has a point (x, y, z). Exact. O(n).")
      .def(
          "locate",
          [](const PolyhedralSet& set, const nb::object& point) {
            return word_of(location(set, point));
          },
          "point"_a, "Where a point (x, y, z) lies: inside, boundary or outside. Exact. O(n).")
      .def_prop_ro(
          "volume",
          [](const PolyhedralSet& set) { return quantity(computed([&] { return volume(set); })); },
          nb::sig("def volume(self) -> fractions.Fraction"), "The exact volume. Linear.")
      .def_prop_ro(
          "planes", [](const PolyhedralSet& set) { return set.faces.size(); },
          "In how many oriented planes its faces lie.")
      .def_prop_ro("is_empty", [](const PolyhedralSet& set) { return set.empty(); });
}

void bind_sums_in_space(nb::module_& module) {
  module.def(
      "definition_sum_in_space",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling) {
        return definition_sum(P.value(), Q.value(), to_scaling(scaling));
      },
      "P"_a, "Q"_a, "scaling"_a, Released(),
      "S P ⊕ Q, the union of the sums of all pairs of convex pieces, of valid polyhedra that do "
      "not cross themselves. Raises LimitExceeded for too many pairs. Exact.");
  module.def(
      "edge_sum_in_space",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling, unsigned threads) {
        return edge_sum(P.value(), Q.value(), to_scaling(scaling), build_on(threads)).set;
      },
      "P"_a, "Q"_a, "scaling"_a, "threads"_a = 1, Released(),
      "S P ⊕ Q, its boundary built from the edges of the reduced convolution (Sec. 3), of valid "
      "polyhedra that do not cross themselves; one may be a plane polygon (a single face), a "
      "segment or a point. Exact.");
  module.def(
      "edge_sum_with_statistics",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling, unsigned threads,
         const std::optional<Progress>& progress) {
        const EdgeSum sum =
            edge_sum(P.value(), Q.value(), to_scaling(scaling), build_on(threads, progress));
        const EdgeStatistics& statistics = sum.statistics;
        const std::map<std::string, std::uint64_t> counts{
            {"convolution_facets", sum.facets},      {"covered_facets", sum.covered_facets},
            {"near_pairs", sum.near_pairs},          {"tests_by_cells", statistics.covered},
            {"pieces", statistics.pieces},           {"candidates", statistics.candidates},
            {"boundary_pieces", sum.edges},          {"collision_tests", statistics.tests},
            {"by_float", statistics.signs.by_float}, {"by_integer", statistics.signs.by_integer}};
        return std::pair(sum.set, counts);
      },
      "P"_a, "Q"_a, "scaling"_a, "threads"_a = 1, "progress"_a = nb::none(), Released(),
      "The same with what was counted on the way. `progress` is told how many of how many steps "
      "are "
      "done.");
  module.def(
      "timed_edge_sum",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling) {
        const auto began = std::chrono::steady_clock::now();
        const EdgeSum sum = edge_sum(P.value(), Q.value(), to_scaling(scaling));
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
        return std::tuple(taken.count(), 1e-9 * double(sum.statistics.nanoseconds_of_tests),
                          sum.statistics.tests);
      },
      "P"_a, "Q"_a, "scaling"_a, Released(),
      "Seconds of the same on one thread, seconds of these for collision tests, and the tests.");
  module.def(
      "tight_passages_in_space",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling) {
        return canonical_json(tight_passages_in_space(P.value(), Q.value(), to_scaling(scaling)));
      },
      "P"_a, "Q"_a, "scaling"_a, Released(),
      "The closure of int(S P ⊕ Q) less ri S P ⊕ ri Q, as canonical JSON: sheets, lines and "
      "points. "
      "Of valid polyhedra that do not cross themselves; one may be a segment or a point. Complete "
      "and exact. Raises LimitExceeded for too many pairs of convex pieces.");
  module.def(
      "convex_pieces",
      [](const Surface& surface) {
        std::vector<Surface> result;
        for (Polyhedron& piece : convex_pieces(surface.value())) {
          result.emplace_back(std::move(piece));
        }
        return result;
      },
      "polyhedron"_a, Released(),
      "Convex polyhedra with disjoint interiors whose union a valid polyhedron is. Exact.");
}

}  // namespace

void bind_polyhedral_set(nb::module_& module) {
  auto bound = nb::class_<PolyhedralSet>(
      module, "PolyhedralSet",
      "A regular closed set in space, exact: what is exposed in each of its planes. A value: never "
      "changed, equal to each set of the same points.");
  bind_set(bound);
  bind_space_surface(module, bound);
  bind_sums_in_space(module);
}

}  // namespace minkref::python
