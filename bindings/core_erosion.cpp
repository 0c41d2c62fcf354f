#include "bindings/core_erosion.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/plane_scale.hpp"
#include "bindings/stopwatch.hpp"
#include "reference/plane/erosion/erosion.hpp"
#include "reference/plane/erosion/outside.hpp"
#include "reference/plane/route_names.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

template <class Find>
TimedSum timed(Find&& find) {
  const Stopwatch watch;
  Sum found = find();
  const double seconds = watch.seconds();
  return {{std::move(found.region), true},
          found.components,
          found.holes,
          seconds,
          std::move(found.statistics),
          LaterPassages({}, std::move(found.tight_passages))};
}

void refuse_large_erosion(const PolygonSet& P, const PolygonSet& Q) {
  if (P.is_region() && !Q.empty()) refuse_large_convolution(outside_of(P).set, Q);
}

TimedSum eroded(const Set& P, const Set& Q, const std::string& scale, const std::string& route) {
  const ScaledOperand operand(P.value, scale);
  refuse_large_erosion(P.value, Q.value);
  return timed(
      [&] { return erosion(operand.set(), Q.value, operand.scale(), route_named(route)); });
}

TimedSum opened(const Set& P, const Set& Q, const std::string& scale) {
  const ScaledOperand operand(P.value, scale);
  refuse_large_erosion(P.value, Q.value);
  return timed([&] { return opening(operand.set(), Q.value, operand.scale()); });
}

TimedSum closed(const Set& P, const Set& Q, const std::string& scale) {
  const ScaledOperand operand(P.value, scale);
  refuse_large_convolution(P.value, Q.value);
  return timed([&] { return closing(operand.set(), Q.value, operand.scale()); });
}

EdgeRow row_in_operands(const Outside& outside, const EdgeRow& row) {
  const auto& [kind, sign, edge_ring, edge, vertex_ring, vertex] = row;
  ConvolutionEdge contact;
  contact.kind = kind == "S" ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T;
  contact.edge = {edge_ring, edge};
  contact.vertex = {vertex_ring, vertex};
  contact = outside.in_operands(contact);
  return {
      kind, sign, contact.edge.ring, contact.edge.index, contact.vertex.ring, contact.vertex.index};
}

void bind_outside(nb::module_& module) {
  unchanging(nb::class_<Outside>(module, "Outside",
                                 "A box less the interior of a polygon set P with an area: the "
                                 "outside of P as an operand, ring 0 being the box."))
      .def(
          "__init__", [](Outside* self, const Set& P) { new (self) Outside(outside_of(P.value)); },
          "P"_a, Released(),
          "The box is wider than P by three widths on either side, and higher by three heights. P "
          "is valid.")
      .def_prop_ro(
          "set", [](const Outside& outside) { return Set{outside.set}; }, Released())
      .def("in_operands", row_in_operands, "row"_a,
           "A row of a convolution of the set, with the edge or the vertex of P in it.")
      .def(
          "edge_of_P",
          [](const Outside& outside, std::uint32_t ring, std::uint32_t index) {
            const VertexId edge = outside.edge_of_P({ring, index});
            return std::pair(edge.ring, edge.index);
          },
          "ring"_a, "index"_a, "Ring and index of the edge of P that an edge of the set is.")
      .def(
          "vertex_of_P",
          [](const Outside& outside, std::uint32_t ring, std::uint32_t index) {
            const VertexId vertex = outside.vertex_of_P({ring, index});
            return std::pair(vertex.ring, vertex.index);
          },
          "ring"_a, "index"_a, "Ring and index of the vertex of P that a vertex of the set is.");
}

}  // namespace

void bind_erosion(nb::module_& module) {
  bind_outside(module);
  module.def("erosion", eroded, "P"_a, "Q"_a, "scale"_a, "route"_a = "paper", Released(),
             "sP less Q: the places x with x + Q within sP; the tight passages are its remnants. "
             "By \"SX,SY\" for S P. Raises BadInput.");
  module.def("opening", opened, "P"_a, "Q"_a, "scale"_a, Released(),
             "The erosion of sP by Q, plus Q; what lies beside the region are tight passages.");
  module.def("closing", closed, "P"_a, "Q"_a, "scale"_a, Released(), "sP + Q, eroded by Q.");
  module.def(
      "negated", [](const Set& Q) { return Set{negated(Q.value)}; }, "Q"_a, Released(),
      "-Q; rings and vertices keep their numbers.");
  module.def(
      "inside_out",
      [](const Set& sum) {
        Canonical found = inside_out(sum.value);
        return std::tuple(Set{std::move(found.region), true}, found.components, found.holes);
      },
      "sum"_a, Released(),
      "The holes of the sum of an outside as a set, its components and its holes.");
  module.def(
      "least_scale_with_room",
      [](const Set& P, const Set& Q) {
        const auto least = least_scale_with_room(P.value, Q.value);
        return least ? std::optional(to_string(*least)) : std::nullopt;
      },
      "P"_a, "Q"_a, Released(),
      "The least scale at which the box of Q fits into that of sP; None if it does at no scale.");
}

}  // namespace minkref::python
