// All radii of a sum with a disc, in Python.
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/core.hpp"
#include "python/core_build.hpp"
#include "python/diagram_row.hpp"
#include "python/stopwatch.hpp"
#include "python/vector_caster.hpp"
#include "reference/disc/index/index_measures.hpp"
#include "reference/disc/index/index_region.hpp"
#include "reference/disc/region/offset_region.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct DiscIndex {
  DiscIndex(PolygonSet set, const BuildOptions& options)
      : P(std::move(set)),
        curves(offset_curves(P)),
        index(P, options),
        history(offset_history(index)),
        regions(index, history, curves),
        measures(index) {}

  Rational square(const std::string& text) const {
    Rational value = parse_rational(text);
    if (value <= 0) {
      throw BadInput("bad-radius", "the square of the radius is " + text, "give a radius above 0");
    }
    return value;
  }
  std::pair<double, double> radius(std::uint32_t number) const {
    const Interval bounds =
        index.diagram().radius(index.diagram().events[index.event_at(number - 1)]);
    return {bounds.lower(), bounds.upper()};
  }

  PolygonSet P;
  OffsetCurves curves;
  OffsetIndex index;
  OffsetHistory history;
  IndexRegions regions;
  IndexMeasures measures;
  double seconds = 0;
};

/// Parts of the boundary at one radius, ring by ring.
struct Vertices {
  IndexBoundary boundary;
  std::vector<BoundedPoint> points;
  std::vector<std::uint32_t> starts;
};

void find_vertices(const DiscIndex& self, double radius, Vertices& found) {
  const Rational exact = from_double(radius);
  const std::uint32_t gap = self.index.place(exact * exact).gap;
  self.index.boundary(gap, found.boundary);
  self.index.vertices(found.boundary, Interval(radius), found.points, found.starts);
}

nb::object as_arrays(std::unique_ptr<Vertices> found) {
  static_assert(sizeof(BoundedPoint) == 3 * sizeof(double));
  Vertices* all = found.release();
  const nb::capsule owner(all, [](void* p) noexcept { delete static_cast<Vertices*>(p); });
  using Points = nb::ndarray<nb::numpy, const double>;
  using Starts = nb::ndarray<nb::numpy, const std::uint32_t>;
  const double* points = all->points.empty() ? nullptr : &all->points.front().x;
  return nb::make_tuple(Points(points, {all->points.size(), 3}, owner),
                        Starts(all->starts.data(), {all->starts.size()}, owner));
}

/// Birth and end, by bounds of their radii, none of a hole of P; the place where it ends, rounded;
/// the number of the hole that it was a part of.
using HoleRow = std::tuple<std::optional<std::pair<double, double>>, std::pair<double, double>,
                           std::pair<double, double>, std::uint32_t>;

std::vector<HoleRow> holes(const DiscIndex& self) {
  std::vector<HoleRow> rows;
  const DiagramEvents& diagram = self.index.diagram();
  for (const OffsetHole& hole : self.history.all_holes) {
    const auto place = diagram.place(diagram.events[hole.ends_at]);
    std::optional<std::pair<double, double>> birth;
    if (hole.birth > 0) birth = self.radius(hole.birth);
    rows.emplace_back(birth, self.radius(hole.end),
                      std::pair(approximate(place.x), approximate(place.y)), hole.from);
  }
  return rows;
}

/// What becomes of holes and components at an event: holes that are born, each with the one that it
/// was a part of; holes that end; polygons of P whose components join.
struct EventChanges {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> born;
  std::vector<std::uint32_t> ended;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
};

/// By number of the event, and that of its radius.
using ChangeRow =
    std::tuple<std::uint32_t, std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>,
               std::vector<std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>>;

std::vector<ChangeRow> changes(const DiscIndex& self) {
  std::map<std::uint32_t, EventChanges> of_event;
  for (std::uint32_t k = 0; k < self.history.all_holes.size(); ++k) {
    const OffsetHole& hole = self.history.all_holes[k];
    if (hole.birth > 0) of_event[hole.born_at].born.emplace_back(k + 1, hole.from);
    of_event[hole.ends_at].ended.push_back(k + 1);
  }
  for (const ComponentJoin& join : self.history.joins) {
    if (join.radius > 0) of_event[join.event].joined.emplace_back(join.a, join.b);
  }
  std::vector<ChangeRow> rows;
  for (auto& [event, all] : of_event) {
    rows.emplace_back(event, self.index.radius_number(event), std::move(all.born),
                      std::move(all.ended), std::move(all.joined));
  }
  return rows;
}

/// The radius from which two polygons of P, by number, are in one component; none where they touch.
using JoinRow = std::tuple<std::optional<std::pair<double, double>>, std::uint32_t, std::uint32_t>;

std::vector<JoinRow> joins(const DiscIndex& self) {
  std::vector<JoinRow> rows;
  for (const ComponentJoin& join : self.history.joins) {
    std::optional<std::pair<double, double>> radius;
    if (join.radius > 0) radius = self.radius(join.radius);
    rows.emplace_back(radius, join.a, join.b);
  }
  return rows;
}

}  // namespace

void bind_disc_index(nb::module_& module) {
  nb::class_<DiscIndex>(module, "DiscIndex", "P + a disc at all radii.")
      .def("__len__", [](const DiscIndex& self) { return self.index.radii(); })
      .def_ro("seconds", &DiscIndex::seconds, "Of the build.")
      .def_prop_ro("exact_signs",
                   [](const DiscIndex& self) { return self.index.diagram().exact_signs; })
      .def_prop_ro(
          "parts", [](const DiscIndex& self) { return self.index.graph().halves.size() / 2; },
          "Of the outer Voronoi diagram, on each of which the radius grows or shrinks.")
      .def(
          "radii",
          [](const DiscIndex& self) {
            std::vector<std::pair<double, double>> all;
            for (std::uint32_t k = 1; k <= self.index.radii(); ++k) all.push_back(self.radius(k));
            return all;
          },
          "Bounds of the radii of events, ascending, each once.")
      .def(
          "counts",
          [](const DiscIndex& self, const std::string& squared_radius) {
            const auto place = self.index.place(self.square(squared_radius));
            return std::pair(self.history.components(place), self.history.holes(place));
          },
          "squared_radius"_a, "(components, holes) at a radius, exact, events too.")
      .def(
          "measures",
          [](const DiscIndex& self, const std::string& squared_radius) {
            const Rational square = self.square(squared_radius);
            const OffsetMeasures found =
                self.measures.at(self.index.place(square), sqrt(Interval(square)));
            return std::pair(std::pair(found.area.lower(), found.area.upper()),
                             std::pair(found.length.lower(), found.length.upper()));
          },
          "squared_radius"_a, Released(),
          "Area and length of the boundary, each between two doubles, without the boundary.")
      .def(
          "at_event",
          [](const DiscIndex& self, const std::string& squared_radius) {
            return self.index.place(self.square(squared_radius)).at_event;
          },
          "squared_radius"_a, "Whether a radius is that of an event. Exact.")
      .def(
          "canonical_json",
          [](const DiscIndex& self, const std::string& squared_radius) {
            const Rational square = self.square(squared_radius);
            const auto place = self.index.place(square);
            if (place.at_event) return canonical_json(offset_region(self.P, square));
            return canonical_json(self.regions.at(place.gap).form, self.curves, square);
          },
          "squared_radius"_a, Released(),
          "The canonical form: read off, or at the radius of an event the static sum.")
      .def(
          "vertices",
          [](const DiscIndex& self, double radius) {
            auto found = std::make_unique<Vertices>();
            find_vertices(self, radius, *found);
            return as_arrays(std::move(found));
          },
          "radius"_a, nb::sig("def vertices(self, radius: float) -> tuple[typing.Any, typing.Any]"),
          "x, y and a bound of the error of each vertex of the boundary, ring by ring, the sum on "
          "the left; and where rings start. At the radius of an event those just above.")
      .def(
          "place",
          [](const DiscIndex& self, const std::string& squared_radius) {
            const auto place = self.index.place(parse_rational(squared_radius));
            return std::pair(place.gap, place.at_event);
          },
          "squared_radius"_a,
          "How many radii of events are not above one, and whether the last is this. Exact.")
      .def(
          "rows",
          [](const DiscIndex& self, std::size_t first, std::size_t count) {
            return diagram_rows(self.index.diagram(), first, count);
          },
          "first"_a, "count"_a, Released(), "Events as DiagramEvents.rows has them.")
      .def(
          "kinds",
          [](const DiscIndex& self) {
            std::vector<std::string> kinds;
            for (const DiagramEvent& event : self.index.diagram().events) {
              kinds.emplace_back(name(event.kind));
            }
            return kinds;
          },
          "Of all events, in order.")
      .def("changes", &changes,
           "(event, number of its radius from 1 on, holes that are born and the hole that each was "
           "a part of, holes that end, polygons whose components join), of events at which there "
           "are any.")
      .def("holes", &holes,
           "(birth or None, end, place of the end, hole that it was a part of), numbered from 1.")
      .def("joins", &joins, "(radius or None, polygon, polygon): from where on components are one.")
      .def(
          "seconds_of_queries",
          [](const DiscIndex& self, const std::vector<double>& radii, unsigned rounds) {
            Vertices found;
            for (const double radius : radii) find_vertices(self, radius, found);
            const Stopwatch watch;
            for (unsigned k = 0; k < rounds; ++k) {
              for (const double radius : radii) find_vertices(self, radius, found);
            }
            return watch.seconds() / rounds;
          },
          "radii"_a, "rounds"_a = 1, Released(),
          "Of all vertices at each of some radii, without Python.");
  module.def(
      "disc_index",
      [](const Set& P, unsigned threads) -> DiscIndex* {
        const Stopwatch watch;
        auto index = std::make_unique<DiscIndex>(P.value, build_on(threads));
        index->seconds = watch.seconds();
        return index.release();
      },
      "P"_a, "threads"_a = 1, Released(),
      "P + a disc about the origin at all radii. Raises BadInput, LimitExceeded.");
}

}  // namespace minkref::python
