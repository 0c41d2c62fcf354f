// Sums in space of polyhedra of any shape.
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <functional>
#include <string>

#include "python/core.hpp"
#include "python/core_space.hpp"
#include "python/vector_caster.hpp"
#include "reference/space/definition/convex_pieces.hpp"
#include "reference/space/definition/definition_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {

void bind_polyhedral_set(nb::module_& module) {
  unchanging(nb::class_<PolyhedralSet>(
                 module, "PolyhedralSet",
                 "A regular closed set in space, exact: what is exposed in each of its planes. A "
                 "value: never changed, equal to each set of the same points."))
      .def(
          "__eq__", [](const PolyhedralSet& a, const PolyhedralSet& b) { return a == b; },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__",
           [](const PolyhedralSet& set) {
             return std::hash<std::string>()(canonical_json(set)) >> 1;
           })
      .def("__repr__",
           [](const PolyhedralSet& set) {
             return "<PolyhedralSet: faces in " + std::to_string(set.faces.size()) + " planes>";
           })
      .def(
          "canonical_json", [](const PolyhedralSet& set) { return canonical_json(set); },
          Released(), "The text of which the digest is taken.")
      .def(
          "volume", [](const PolyhedralSet& set) { return to_string(volume(set)); }, Released(),
          "The exact volume.")
      .def_prop_ro(
          "planes", [](const PolyhedralSet& set) { return set.faces.size(); },
          "In how many oriented planes its faces lie.")
      .def_prop_ro("is_empty", [](const PolyhedralSet& set) { return set.empty(); });
  module.def(
      "definition_sum_in_space",
      [](const Surface& P, const Surface& Q, const ExactSpacePoint& scaling) {
        return definition_sum(P.value(), Q.value(), to_scaling(scaling));
      },
      "P"_a, "Q"_a, "scaling"_a, Released(),
      "S P ⊕ Q, the union of the sums of all pairs of convex pieces, of valid polyhedra that do "
      "not cross themselves. Raises LimitExceeded for too many pairs. Exact.");
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

}  // namespace minkref::python
