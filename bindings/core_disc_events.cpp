// Radii at which sums with a disc change, for Python.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/diagram_row.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/polynomial.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct TimedDiagramEvents {
  DiagramEvents found;
  double seconds;
};

}  // namespace

const char* name(DiagramEvent::Kind kind) {
  switch (kind) {
    case DiagramEvent::Kind::corner:
      return "corner";
    case DiagramEvent::Kind::joint:
      return "joint";
    case DiagramEvent::Kind::saddle:
      return "saddle";
    case DiagramEvent::Kind::ridge:
      return "ridge";
    case DiagramEvent::Kind::maximum:
      return "maximum";
  }
  return "";
}

FeatureName vertex_name(const DiagramEvents& found, std::uint32_t feature) {
  const Point at = found.vertex(feature);
  return {"vertex", to_string(at.x), to_string(at.y)};
}

FeatureName edge_row(const VertexId& id) {
  return {"edge", std::to_string(id.ring), std::to_string(id.index)};
}

SquareRow square_row(const RootNumber& squared_radius) {
  const Polynomial polynomial = without_multiple_roots(squared_radius.polynomial());
  const Enclosure radius = enclose(root_of(squared_radius));
  SquareRow row{std::nullopt, {}, {radius.lower, radius.upper}};
  for (const Rational& c : polynomial) row.polynomial.push_back(to_string(c));
  if (polynomial.size() == 2) row.rational = to_string(Rational(-polynomial[0]));
  return row;
}

DiagramRow diagram_row(const DiagramEvents& found, const DiagramEvent& event) {
  const Equidistant<RootNumber> exact = found.exact(event);
  const SquareRow square = square_row(exact.squared_radius);
  std::vector<FeatureName> features;
  for (std::size_t k = 0; k < event.features.size(); ++k) {
    features.push_back(event.edges[k] == OffsetPatch::none
                           ? vertex_name(found, event.features[k])
                           : edge_row(edge_name(found, event.edges[k], event)));
  }
  return {name(event.kind),
          square.rational,
          square.polynomial,
          square.radius,
          {nearest_double(exact.at.x), nearest_double(exact.at.y)},
          features};
}

FeatureName side_name(const DiagramEvents& diagram, std::uint32_t node, std::uint32_t number,
                      Past past) {
  const BoundarySide& side = diagram.walks.sides[number];
  if (side.is_arc) return vertex_name(diagram, side.feature);
  if (node < diagram.events.size()) {
    return edge_row(edge_name(diagram, side.edge, diagram.events[node], past));
  }
  // A reflex vertex: the side starts there, or ends.
  const std::uint32_t vertex = past == Past::ends ? side.to : side.from;
  return edge_row(edge_name(diagram, side.edge, diagram.curves.features[vertex].centre, past));
}

PartEnd part_end(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t node,
                 std::uint32_t vertex) {
  if (graph.is_event(node)) return {"event", {std::to_string(node)}};
  std::vector<std::uint32_t> vertices{vertex};
  if (graph.is_infinite(node)) {
    const HullGap& gap = diagram.gaps[node - graph.events];
    vertices = {gap.from, gap.to};
  }
  std::vector<std::string> told;
  for (const std::uint32_t each : vertices) {
    const Point at = diagram.vertex(each);
    told.push_back(to_string(at.x));
    told.push_back(to_string(at.y));
  }
  return {graph.is_infinite(node) ? "infinity" : "vertex", told};
}

std::vector<DiagramRow> diagram_rows(const DiagramEvents& found, std::size_t first,
                                     std::size_t count) {
  std::vector<DiagramRow> rows;
  for (std::size_t k = first; k < found.events.size() && k - first < count; ++k) {
    rows.push_back(diagram_row(found, found.events[k]));
  }
  return rows;
}

DiagramEvents diagram_of(const PolygonSet& P, unsigned threads,
                         const std::optional<std::vector<PlaceRow>>& places) {
  if (!places) return diagram_events(P, build_on(threads));
  std::vector<FoundPlace> found;
  for (const auto& [a, b, c, branch] : *places) found.push_back({{a, b, c}, branch});
  return diagram_events(P, found, build_on(threads));
}

void bind_disc_events(nb::module_& module) {
  nb::class_<TimedDiagramEvents>(module, "DiagramEvents",
                                 "The radii at which P + a disc changes, ascending.")
      .def("__len__", [](const TimedDiagramEvents& self) { return self.found.events.size(); })
      .def_ro("seconds", &TimedDiagramEvents::seconds)
      .def_prop_ro("exact_signs",
                   [](const TimedDiagramEvents& self) { return self.found.exact_signs; })
      .def(
          "kinds",
          [](const TimedDiagramEvents& self) {
            std::vector<std::string> kinds;
            for (const DiagramEvent& event : self.found.events)
              kinds.emplace_back(name(event.kind));
            return kinds;
          },
          Released(), "Of all events, in order.")
      .def(
          "rows",
          [](const TimedDiagramEvents& self, std::size_t first, std::size_t count) {
            return diagram_rows(self.found, first, count);
          },
          "first"_a, "count"_a, Released(),
          "(kind, squared radius or None, polynomial, bounds of the radius, place, features).");
  module.def(
      "diagram_events",
      [](const Set& P, unsigned threads, const std::optional<std::string>& from,
         const std::optional<std::string>& to,
         const std::optional<std::vector<PlaceRow>>& places) -> TimedDiagramEvents {
        const Stopwatch watch;
        DiagramEvents found = diagram_of(P.value, threads, places);
        const auto is_out = [&](const DiagramEvent& event) {
          const auto side = [&](const Rational& bound) {
            const Interval radius = found.radius(event);
            const Interval way = radius * radius - Interval(bound);
            if (const auto certain = certified_sign(way)) return *certain;
            return compare(found.exact(event).squared_radius, RootNumber(bound));
          };
          return (from && side(parse_rational(*from)) < 0) || (to && side(parse_rational(*to)) > 0);
        };
        std::erase_if(found.events, is_out);
        return {std::move(found), watch.seconds()};
      },
      "P"_a, "threads"_a = 1, "from_squared"_a = nb::none(), "to_squared"_a = nb::none(),
      "places"_a = nb::none(), Released(),
      "Where and at which radii P + a disc about the origin changes, perhaps in a window of "
      "squared radii. `places`: what DiscIndex.places says of the same set: proven again, not "
      "trusted. Raises BadInput, LimitExceeded.");
}

}  // namespace minkref::python
