// The convolutions in Python.
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <tuple>

#include "python/core.hpp"
#include "python/vector_caster.hpp"
#include "reference/plane/convolution/convolution.hpp"

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
  const Rational s = parse_rational(scale);
  const auto edges =
      reduced ? reduced_convolution(P.value, Q.value) : full_convolution(P.value, Q.value);
  std::vector<SegmentTuple> rows;
  rows.reserve(edges.size());
  for (const auto& edge : edges) {
    look_for_interrupt();
    const Segment segment = at_scale(edge, P.value, Q.value, s);
    rows.emplace_back(to_double(segment.start.x), to_double(segment.start.y),
                      to_double(segment.end.x), to_double(segment.end.y));
  }
  return rows;
}

}  // namespace

void bind_convolution(nb::module_& module) {
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
