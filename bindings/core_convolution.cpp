// The convolutions in Python.
#include "bindings/core_convolution.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/plane_scale.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/decimal.hpp"
#include "reference/error.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {

std::vector<EdgeRow> convolution_rows(const std::vector<ConvolutionEdge>& edges) {
  std::vector<EdgeRow> rows;
  rows.reserve(edges.size());
  for (const auto& edge : edges) {
    look_for_interrupt();
    rows.emplace_back(edge.kind == ConvolutionEdge::Kind::S ? "S" : "T", edge.sign, edge.edge.ring,
                      edge.edge.index, edge.vertex.ring, edge.vertex.index);
  }
  return rows;
}

namespace {

using SegmentTuple = std::tuple<double, double, double, double>;

std::vector<SegmentTuple> segments(const Set& P, const Set& Q, const std::string& scale,
                                   bool reduced) {
  const ScaledOperand operand(P.value, scale);
  const PolygonSet& p = operand.set();
  const auto edges = reduced ? reduced_convolution(p, Q.value) : full_convolution(p, Q.value);
  std::vector<SegmentTuple> rows;
  rows.reserve(edges.size());
  for (const auto& edge : edges) {
    look_for_interrupt();
    const Segment segment = at_scale(edge, p, Q.value, operand.scale());
    rows.emplace_back(to_double(segment.start.x), to_double(segment.start.y),
                      to_double(segment.end.x), to_double(segment.end.y));
  }
  return rows;
}

/// A convolution at one scale, keeping its operands.
struct Convolution {
  PolygonSet P, Q;
  Rational scale;
  std::vector<ConvolutionEdge> edges;

  Convolution(const Set& p, const Set& q, const std::string& s, bool full, Between between)
      : Convolution(ScaledOperand(p.value, s), q, full, between) {}
  Convolution(const ScaledOperand& p, const Set& q, bool full, Between between)
      : P(p.set()), Q(q.value), scale(p.scale()) {
    refuse_bad_operands(P, Q, scale);
    refuse_large_convolution(P, Q, full, between);
    edges = convolution(P, Q, full, between);
  }
};

Between between_named(const std::string& name) {
  if (name == "half-open") return Between::half_open;
  if (name == "open") return Between::open;
  if (name == "closed") return Between::closed;
  throw BadInput("unknown-reading", "there is no reading of \"between\" called \"" + name + "\"",
                 "use half-open, open or closed");
}

void require_range(const Convolution& found, std::size_t first, std::size_t last) {
  if (first > last || last > found.edges.size()) throw nb::index_error("there is no such edge");
}

/// The edge with its exact start, end and direction vector.
using PlacedRow = std::tuple<EdgeRow, ExactPoint, ExactPoint, ExactPoint>;

std::vector<PlacedRow> placed_rows(const Convolution& found, std::size_t first, std::size_t last) {
  require_range(found, first, last);
  const std::vector<ConvolutionEdge> part(found.edges.begin() + static_cast<std::ptrdiff_t>(first),
                                          found.edges.begin() + static_cast<std::ptrdiff_t>(last));
  std::vector<EdgeRow> named = convolution_rows(part);
  std::vector<PlacedRow> rows;
  rows.reserve(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    look_for_interrupt();
    const Segment at = at_scale(part[i], found.P, found.Q, found.scale);
    const Point along{at.end.x - at.start.x, at.end.y - at.start.y};
    rows.emplace_back(std::move(named[i]), to_strings(at.start), to_strings(at.end),
                      to_strings(along));
  }
  return rows;
}

/// Start and end as decimals.
std::vector<std::pair<ExactPoint, ExactPoint>> decimals(const Convolution& found, std::size_t first,
                                                        std::size_t last) {
  require_range(found, first, last);
  const auto text = [](const Point& p) { return ExactPoint(decimal(p.x), decimal(p.y)); };
  std::vector<std::pair<ExactPoint, ExactPoint>> rows;
  rows.reserve(last - first);
  for (std::size_t i = first; i < last; ++i) {
    look_for_interrupt();
    const Segment at = at_scale(found.edges[i], found.P, found.Q, found.scale);
    rows.emplace_back(text(at.start), text(at.end));
  }
  return rows;
}

bool has_decimals(const Convolution& found, std::size_t last) {
  require_range(found, 0, last);
  const auto exactly = [](const Point& p) {
    return has_exact_decimal(p.x) && has_exact_decimal(p.y);
  };
  return std::all_of(found.edges.begin(), found.edges.begin() + static_cast<std::ptrdiff_t>(last),
                     [&](const ConvolutionEdge& edge) {
                       look_for_interrupt();
                       const Segment at = at_scale(edge, found.P, found.Q, found.scale);
                       return exactly(at.start) && exactly(at.end);
                     });
}

Fields counts_of(const Convolution& found) {
  std::size_t s = 0, negative = 0;
  for (const ConvolutionEdge& edge : found.edges) {
    s += edge.kind == ConvolutionEdge::Kind::S ? 1 : 0;
    negative += edge.sign < 0 ? 1 : 0;
  }
  Fields fields;
  fields["S"] = s;
  fields["T"] = found.edges.size() - s;
  fields["negative"] = negative;
  return fields;
}

void bind_placed_convolution(nb::module_& module) {
  nb::class_<Convolution>(module, "Convolution", "The edges of a convolution at one scale.")
      .def(
          "__init__",
          [](Convolution* self, const Set& P, const Set& Q, const std::string& scale, bool full,
             const std::string& compatible) {
            const Between between = between_named(compatible);
            const Computing released;
            new (self) Convolution(P, Q, scale, full, between);
          },
          "P"_a, "Q"_a, "scale"_a, "full"_a = false, "compatible"_a = "half-open",
          "Reduced or full, by a reading of \"between\": half-open, open or closed. Exact.")
      .def("__len__", [](const Convolution& self) { return self.edges.size(); })
      .def("counts", counts_of, "S- and T-edges, and edges of the sign -1.")
      .def("rows", placed_rows, "first"_a, "last"_a, Released(),
           "Edges first to last - 1: (a row as reduced_convolution's, start, end, direction).")
      .def("decimals", decimals, "first"_a, "last"_a, Released(),
           "Start and end of edges first to last - 1 as decimals, rounded where they are none.")
      .def("has_decimals", has_decimals, "last"_a, Released(),
           "Whether none of the first edges is rounded by decimals().");
}

}  // namespace

void bind_convolution(nb::module_& module) {
  bind_placed_convolution(module);
  const auto bind_rows = [&](const char* name, auto convolution) {
    module.def(
        name,
        [convolution](const Set& P, const Set& Q) {
          return convolution_rows(convolution(P.value, Q.value));
        },
        "P"_a, "Q"_a, Released(),
        "Rows (kind, sign, edge ring, edge index, vertex ring, vertex index).");
  };
  bind_rows("reduced_convolution", reduced_convolution);
  bind_rows("full_convolution", full_convolution);
  module.def("convolution_segments", segments, "P"_a, "Q"_a, "scale"_a, "reduced"_a, Released(),
             "For drawing: rows x0, y0, x1, y1.");
}

}  // namespace minkref::python
