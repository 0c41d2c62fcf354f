// Sums of convex polyhedra under non-uniform scaling for Python.
#include "bindings/core_convex.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_shapes.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/space/canonical_polyhedron.hpp"
#include "reference/space/convex/convex_sum.hpp"
#include "reference/space/convex/incompatibility.hpp"
#include "reference/space/convex/segment_sum.hpp"
#include "reference/space/convex/static_convex_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

ConvexBody certified(const Surface& surface, const std::string& source) {
  ConvexBody body;
  refuse_as_read(surface.reading, source,
                 [&] { body.value = std::make_shared<const ConvexPolyhedron>(surface.value()); });
  return body;
}

Compatibility by_route(const Contacts& contacts, const std::string& route) {
  if (route == "traversal") return by_traversal(contacts);
  if (route == "brute-force") return by_brute_force(contacts);
  throw BadInput("unknown-route", "there is no route \"" + route + "\"",
                 "choose traversal or brute-force");
}

ConvexSum static_sum(const ConvexBody& P, const ConvexBody& Q, const ExactSpacePoint& scaling,
                     const std::string& route) {
  const Scaling at = to_scaling(scaling);
  require_positive(at);
  Contacts contacts(*P.value, *Q.value);
  contacts.rescale(at);
  return surface_of(*P.value, *Q.value, at, by_route(contacts, route));
}

/// Keeps its operands alive.
struct MovingConvexSum {
  Body P, Q;
  DynamicConvexSum sum;
  MovingConvexSum(const ConvexBody& p, const ConvexBody& q, const ExactSpacePoint& scaling)
      : P(p.value), Q(q.value), sum(*P, *Q, to_scaling(scaling)) {}
};

Fields update(MovingConvexSum& dynamic, const ExactSpacePoint& scaling) {
  const Scaling to = to_scaling(scaling);
  const Stopwatch watch;
  const UpdateCounts counts = computed([&] { return dynamic.sum.update(to); });
  const double seconds = watch.seconds();
  Fields fields = fields_of(counts);
  fields["seconds"] = seconds;
  return fields;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_of(
    const std::vector<SumVertices::Pair>& pairs) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rows;
  rows.reserve(pairs.size());
  for (const auto& [p, q] : pairs) rows.emplace_back(p, q);
  return rows;
}

bool same_state(const MovingConvexSum& dynamic, const std::string& route) {
  Contacts contacts(*dynamic.P, *dynamic.Q);
  contacts.rescale(dynamic.sum.scaling());
  return by_route(contacts, route) == dynamic.sum.compatibility();
}

void check_indices(const ConvexBody& P, std::uint32_t facet, const ConvexBody& Q,
                   std::uint32_t vertex) {
  if (facet >= P.value->facets()) throw nb::index_error("P has no such facet");
  if (vertex >= Q.value->vertices()) throw nb::index_error("Q has no such vertex");
}

/// The squared degree, and the vertex at the witness's other end.
std::pair<std::string, std::uint32_t> degree(const ConvexBody& P, std::uint32_t facet,
                                             const ConvexBody& Q, std::uint32_t vertex,
                                             const ExactSpacePoint& scaling,
                                             const std::string& form) {
  check_indices(P, facet, Q, vertex);
  const Incompatibility found =
      incompatibility(*P.value, facet, *Q.value, vertex, to_scaling(scaling), form_named(form));
  return {to_string(found.squared_degree), Q.value->target(found.witness)};
}

std::optional<std::uint32_t> descent(const ConvexBody& P, std::uint32_t facet, const ConvexBody& Q,
                                     std::uint32_t vertex, const ExactSpacePoint& scaling,
                                     const std::string& form) {
  check_indices(P, facet, Q, vertex);
  return descend(*P.value, facet, *Q.value, vertex, to_scaling(scaling), form_named(form));
}

void bind_body(nb::module_& module) {
  unchanging(
      nb::class_<ConvexBody>(module, "ConvexPolyhedron",
                             "A strictly convex polyhedron, certified: coplanar faces merged, flat "
                             "vertices dropped, vertices in lexicographic order."))
      .def(
          "__init__",
          [](ConvexBody* self, const Surface& surface, const std::string& source) {
            const Computing computing;
            new (self) ConvexBody(certified(surface, source));
          },
          "surface"_a, "source"_a = "",
          "Refuses (BadInput) what is not valid, not convex or has no volume. Exact.")
      .def(
          "__eq__",
          [](const ConvexBody& a, const ConvexBody& b) {
            return canonical_json(a.value->surface()) == canonical_json(b.value->surface());
          },
          nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"), Released())
      .def(
          "__hash__",
          [](const ConvexBody& self) {
            return std::hash<std::string>()(canonical_json(self.value->surface())) >> 1;
          },
          Released())
      .def("__repr__",
           [](const ConvexBody& self) {
             return "<ConvexPolyhedron: " + std::to_string(self.value->vertices()) + " vertices, " +
                    std::to_string(self.value->edges()) + " edges, " +
                    std::to_string(self.value->facets()) + " facets>";
           })
      .def(
          "__getstate__", [](const ConvexBody& self) { return Surface(self.value->surface()); },
          Released())
      .def(
          "__setstate__",
          [](ConvexBody& self, const Surface& state) {
            new (&self) ConvexBody(certified(state, ""));
          },
          Released())
      .def_prop_ro("vertices", [](const ConvexBody& self) { return self.value->vertices(); })
      .def_prop_ro("edges", [](const ConvexBody& self) { return self.value->edges(); })
      .def_prop_ro("facets", [](const ConvexBody& self) { return self.value->facets(); })
      .def_prop_ro(
          "volume",
          [](const ConvexBody& self) {
            return quantity(
                computed([&] { return Rational(sextuple_volume(self.value->surface()) / 6); }));
          },
          nb::sig("def volume(self) -> fractions.Fraction"), "The exact volume. Linear.")
      .def(
          "surface", [](const ConvexBody& self) { return Surface(self.value->surface()); },
          Released(), "In canonical form.");
}

using ParentRow = std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>;

}  // namespace

Fields fields_of(const UpdateCounts& counts) {
  Fields fields;
  MINKREF_PUT(counts, fv_errors, vf_errors, descent_steps, ee_errors, ee_pairs_added, chains_walked,
              chains_mended_by_proof, chains_without_error, facets_examined, chains_examined, signs,
              exact_signs);
  return fields;
}

void bind_convex(nb::module_& module) {
  bind_body(module);
  nb::class_<ConvexSum>(module, "ConvexSum", "A sum of convex polyhedra, in canonical form.")
      .def_prop_ro(
          "surface", [](const ConvexSum& self) { return Surface(self.surface); }, Released())
      .def_prop_ro(
          "vertex_parents", [](const ConvexSum& self) { return pairs_of(self.vertex_parents); },
          Released(), "For each vertex the vertices of P and of Q whose sum it is.")
      .def_prop_ro(
          "facet_parents",
          [](const ConvexSum& self) {
            std::vector<ParentRow> rows;
            for (const auto& [P, Q] : self.facet_parents) rows.emplace_back(P, Q);
            return rows;
          },
          Released(), "For each facet the vertices of the face of P and of that of Q.");
  module.def("convex_sum", &static_sum, "P"_a, "Q"_a, "scaling"_a, "route"_a = "traversal",
             Released(),
             "S P + Q from scratch, by the route traversal or brute-force. Exact, certified closed "
             "and convex.");
  module.def(
      "convex_sum_with_segment",
      [](const ConvexBody& P, const ExactSpacePoint& scaling, const ExactSpacePoint& a,
         const ExactSpacePoint& b) {
        return sum_with_segment(*P.value, to_scaling(scaling), to_point(a), to_point(b));
      },
      "P"_a, "scaling"_a, "a"_a, "b"_a, Released(),
      "S P + the segment from a to b. Exact, certified closed and convex.");
  nb::class_<MovingConvexSum>(module, "DynamicConvexSum",
                              "S P + Q kept up to date (Behar & Lien 2012, Sec. 6).")
      .def(nb::init<const ConvexBody&, const ConvexBody&, const ExactSpacePoint&>(), "P"_a, "Q"_a,
           "scaling"_a, Released())
      .def(
          "update", &update, "scaling"_a,
          "Mends what the new scaling makes wrong: what was found, walked and mended, and seconds.")
      .def(
          "sum", [](const MovingConvexSum& self) { return surface_of(self.sum); }, Released(),
          "In canonical form, certified.")
      .def(
          "pairs",
          [](const MovingConvexSum& self) { return pairs_of(self.sum.vertices().pairs()); },
          Released(), "The pairs of vertices whose sums are corners of facets in generic position.")
      .def_prop_ro("ee_pairs", [](const MovingConvexSum& self) { return self.sum.ee_pairs(); })
      .def("equals_route", &same_state, "route"_a, Released(),
           "Whether all compatible pairs are those that a static route finds.");
  module.def("incompatibility", &degree, "P"_a, "facet"_a, "Q"_a, "vertex"_a, "scaling"_a,
             "form"_a = "corrected", Released(),
             "The squared degree of incompatibility of a facet of P, scaled, and a vertex of Q "
             "(Sec. 6, printed or corrected), and the other end of its witness. Exact.");
  module.def("descend", &descent, "P"_a, "facet"_a, "Q"_a, "vertex"_a, "scaling"_a,
             "form"_a = "corrected", Released(),
             "Where the descent on it ends; None where it comes to a vertex again. Exact.");
  bind_timed_convex_walk(module);
}

}  // namespace minkref::python
