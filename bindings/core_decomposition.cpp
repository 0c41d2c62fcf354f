// Cuts and pieces of a polygon set in Python.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <optional>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/plane/decomposition/cut_pieces.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// from, to, the notch's index, index of an earlier cut at the end.
using CutRow = std::tuple<ExactPoint, ExactPoint, std::uint32_t, std::optional<std::uint32_t>>;
using PieceRow = std::pair<Set, std::vector<std::pair<ExactPoint, ExactPoint>>>;

std::pair<std::vector<CutRow>, std::vector<PieceRow>> cut_at_notches(
    const Set& P, const std::vector<ExactPoint>& notches) {
  std::vector<Point> places;
  places.reserve(notches.size());
  for (const auto& [x, y] : notches) places.push_back({parse_rational(x), parse_rational(y)});
  const NotchCuts found = notch_cuts(P.value, places);
  const auto edges = static_cast<std::uint32_t>(found.boundary.edges.size());
  std::vector<CutRow> cuts;
  for (const NotchCut& cut : found.cuts) {
    std::optional<std::uint32_t> wall;
    if (cut.wall >= edges) wall = cut.wall - edges;
    cuts.emplace_back(to_strings(cut.from), to_strings(cut.to), cut.notch, wall);
  }
  std::vector<PieceRow> pieces;
  for (CutPiece& piece : cut_pieces(found)) {
    std::vector<std::pair<ExactPoint, ExactPoint>> slits;
    for (const auto& [a, b] : piece.slits) slits.emplace_back(to_strings(a), to_strings(b));
    pieces.emplace_back(Set{std::move(piece.region), true}, std::move(slits));
  }
  return {std::move(cuts), std::move(pieces)};
}

}  // namespace

void bind_decomposition(nb::module_& module) {
  module.def("cut_at_notches", &cut_at_notches, "P"_a, "notches"_a, Released(),
             "Cuts, one after another: (from, to, index of the notch, index of the earlier cut "
             "where it ends, or None on the boundary of P); and pieces: (set, slits). Notches are "
             "vertices; those without a sector of more than half a turn get no cut. Exact. Raises "
             "BadInput.");
  module.def(
      "reflex_vertices",
      [](const Set& P) {
        std::vector<ExactPoint> found;
        for (const Point& point : reflex_vertices(P.value)) found.push_back(to_strings(point));
        return found;
      },
      "P"_a, Released(),
      "All vertices at which the interior has more than half a turn, in lexicographic order.");
}

}  // namespace minkref::python
