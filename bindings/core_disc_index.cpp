// All radii of a sum with a disc, for Python.
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
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
#include "reference/disc/diagram/edge_names.hpp"
#include "reference/disc/index/corner_motion.hpp"
#include "reference/disc/index/index_measures.hpp"
#include "reference/disc/index/index_region.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

struct BoundIndex {
  BoundIndex(PolygonSet set, DiagramEvents diagram)
      : P(std::move(set)),
        curves(offset_curves(P)),
        index(std::move(diagram)),
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
  /// The tightest bounds of the events' radii; found once, at the first question.
  const std::vector<std::pair<double, double>>& radii() const {
    const FloatEnvironment standard;
    std::call_once(has_radii_, [&] {
      const DiagramEvents& diagram = index.diagram();
      std::vector<std::pair<double, double>> found;
      for (std::uint32_t k = 0; k < index.radii(); ++k) {
        look_for_interrupt();
        const Enclosure near =
            enclose(root_of(diagram.exact(diagram.events[index.event_at(k)]).squared_radius));
        found.emplace_back(near.lower, near.upper);
      }
      radii_ = std::move(found);
    });
    return radii_;
  }
  std::pair<double, double> radius(std::uint32_t number) const { return radii()[number - 1]; }
  std::pair<double, double> place(std::uint32_t event) const {
    const FloatEnvironment standard;
    const RootPoint at = index.diagram().exact(index.diagram().events[event]).at;
    return {nearest_double(at.x), nearest_double(at.y)};
  }
  /// Measures from the index; from the boundary if sums of doubles are too wide.
  OffsetMeasures measures_at(const Rational& squared_radius) const {
    const OffsetMeasures found = measures.at(index.place(squared_radius), squared_radius);
    return is_sharp(found) ? found : minkref::measures(offset_region(P, squared_radius));
  }

  PolygonSet P;
  OffsetCurves curves;
  DiscIndex index;
  OffsetHistory history;
  IndexRegions regions;
  IndexMeasures measures;
  double seconds = 0;

 private:
  mutable std::once_flag has_radii_;
  mutable std::vector<std::pair<double, double>> radii_;
};

/// Parts of the boundary at one radius, ring by ring.
struct Vertices {
  IndexBoundary boundary;
  std::vector<BoundedPoint> points;
  std::vector<std::uint32_t> starts;
};

void find_vertices(const BoundIndex& self, double radius, Vertices& found) {
  const FloatEnvironment standard;
  const Rational exact = from_double(radius);
  const std::uint32_t gap = self.index.place(exact * exact).gap;
  self.index.boundary(gap, found.boundary);
  self.index.vertices(found.boundary, radius, found.points, found.starts);
}

void refuse_beyond_doubles(const Vertices& found) {
  const bool are_doubles =
      std::all_of(found.points.begin(), found.points.end(),
                  [](const BoundedPoint& p) { return std::isfinite(p.x + p.y + p.error); });
  if (are_doubles) return;
  throw LimitExceeded("beyond-doubles", "vertices of the sum are beyond the range of doubles",
                      "scale the set and the radius");
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

/// Birth and end as bounds of the radii, no birth for a hole of P; the end's place, rounded; the
/// number of the parent hole.
using HoleRow = std::tuple<std::optional<std::pair<double, double>>, std::pair<double, double>,
                           std::pair<double, double>, std::uint32_t>;

std::vector<HoleRow> holes(const BoundIndex& self) {
  std::vector<HoleRow> rows;
  for (const OffsetHole& hole : self.history.all_holes) {
    std::optional<std::pair<double, double>> birth;
    if (hole.birth > 0) birth = self.radius(hole.birth);
    rows.emplace_back(birth, self.radius(hole.end), self.place(hole.ends_at), hole.from);
  }
  return rows;
}

/// Changes of holes and components at an event: born holes, each with its parent hole; ended holes;
/// polygons of P whose components join.
struct EventChanges {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> born;
  std::vector<std::uint32_t> ended;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
};

/// The event's number, its radius's number, and the changes.
using ChangeRow =
    std::tuple<std::uint32_t, std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>,
               std::vector<std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint32_t>>>;

std::vector<ChangeRow> changes(const BoundIndex& self) {
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

/// The radius that joins the components of two polygons of P, given by numbers; none if they touch.
using JoinRow = std::tuple<std::optional<std::pair<double, double>>, std::uint32_t, std::uint32_t>;

std::vector<JoinRow> joins(const BoundIndex& self) {
  std::vector<JoinRow> rows;
  for (const ComponentJoin& join : self.history.joins) {
    std::optional<std::pair<double, double>> radius;
    if (join.radius > 0) radius = self.radius(join.radius);
    rows.emplace_back(radius, join.a, join.b);
  }
  return rows;
}

/// Both ends, and the features on the left and right of the way between them, at its start.
using PartRow = std::tuple<PartEnd, PartEnd, FeatureName, FeatureName>;

std::vector<PartRow> graph_parts(const BoundIndex& self) {
  const DiagramEvents& diagram = self.index.diagram();
  const DiagramGraph& graph = self.index.graph();
  std::vector<PartRow> rows;
  for (std::uint32_t k = 0; k < graph.halves.size(); ++k) {
    const DiagramHalf& half = graph.halves[k];
    if (half.twin < k) continue;
    const auto& sides = diagram.walks.sides;
    rows.emplace_back(part_end(diagram, graph, half.from, sides[half.from_side].from),
                      part_end(diagram, graph, half.to, sides[half.to_side].to),
                      side_name(diagram, half.from, half.from_side, Past::goes_on),
                      side_name(diagram, half.from, graph.halves[half.twin].to_side, Past::ends));
  }
  return rows;
}

std::vector<PlaceRow> place_rows(const BoundIndex& self) {
  std::vector<PlaceRow> rows;
  for (const auto& [of, branch] : self.index.diagram().places()) {
    rows.push_back({of[0], of[1], of[2], branch});
  }
  return rows;
}

/// The diagram for drawing: lengths as of P, places measured from `origin`.
class Drawing {
 public:
  explicit Drawing(const BoundIndex& index)
      : self_(index),
        index_(index.index),
        diagram_(index.index.diagram()),
        unit_(to_double(Rational(1 / diagram_.factor))) {
    const Computing computing;
    name_edges();
    for (std::uint32_t k = 0; k < index_.radii(); ++k) {
      look_for_interrupt();
      const Equidistant<RootNumber> event = diagram_.exact(diagram_.events[index_.event_at(k)]);
      radii_.push_back(nearest_double(root_of(event.squared_radius)));
    }
    for (const DiagramEvent& event : diagram_.events) {
      look_for_interrupt();
      const Equidistant<RootNumber> exact =
          equidistant_places<RootNumber>(diagram_.curves, event.of)[event.branch];
      places_.push_back(unit_ * nearest_double(exact.at.x));
      places_.push_back(unit_ * nearest_double(exact.at.y));
    }
  }

  nb::dict fields() const {
    const FloatEnvironment standard;
    nb::dict all;
    all["origin"] = std::pair(to_double(diagram_.origin.x), to_double(diagram_.origin.y));
    all["radii"] = radii_;
    put_boundary(all);
    put_events(all);
    put_parts(all);
    put_history(all);
    return all;
  }

 private:
  using Numbers = std::vector<std::uint32_t>;
  template <std::size_t n>
  using Rows = std::vector<std::array<std::uint32_t, n>>;

  /// An array as a list of Python.
  template <class Row>
  static nb::list lists(const std::vector<Row>& rows) {
    nb::list all;
    for (const Row& row : rows) {
      nb::list own;
      for (const auto value : row) own.append(value);
      all.append(own);
    }
    return all;
  }

  /// Numbers the features of events: an edge that comes second or later on its line gets an extra
  /// number beyond the curves' numbers.
  void name_edges() {
    const OffsetCurves& curves = diagram_.curves;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    for (const DiagramEvent& event : diagram_.events) {
      near_.push_back(event.features);
      for (std::size_t k = 0; k < event.features.size(); ++k) {
        if (event.edges[k] == OffsetPatch::none) continue;
        const std::uint32_t line = event.features[k];
        const VertexId id = edge_name(diagram_, event.edges[k], event);
        if (id == curves.edges[curves.features[line].edge].id) continue;
        const auto next = static_cast<std::uint32_t>(curves.features.size() + numbers.size());
        const auto [found, is_new] = numbers.try_emplace({id.ring, id.index}, next);
        if (is_new) further_edges_.emplace_back(id, line);
        near_.back()[k] = found->second;
      }
    }
  }

  void put_boundary(nb::dict& all) const {
    nb::list features;
    for (const OffsetCurves::Feature& feature : diagram_.curves.features) {
      if (feature.edge == OffsetPatch::none) {
        const Point& at = feature.centre;
        features.append(nb::make_tuple(unit_ * to_double(at.x), unit_ * to_double(at.y)));
        continue;
      }
      const OffsetEdge& edge = diagram_.curves.edges[feature.edge];
      const JointMotion joint = joint_motion(edge.start, edge.normal);
      features.append(nb::make_tuple(joint.bx, joint.by, edge.id.ring, edge.id.index));
    }
    for (const auto& [id, line] : further_edges_) {
      const OffsetEdge& edge = diagram_.curves.edges[diagram_.curves.features[line].edge];
      const JointMotion joint = joint_motion(edge.start, edge.normal);
      features.append(nb::make_tuple(joint.bx, joint.by, id.ring, id.index, line));
    }
    all["features"] = features;
    Rows<6> sides;
    for (const BoundarySide& side : diagram_.walks.sides) {
      sides.push_back({side.feature, side.from, side.to, side.is_arc ? 1U : 0U,
                       side.ends_at_reflex ? 1U : 0U, diagram_.curves.edges[side.edge].polygon});
    }
    all["sides"] = lists(sides);
    Rows<4> walks;
    for (std::size_t k = 0; k < diagram_.walks.walks.size(); ++k) {
      const BoundaryWalk& walk = diagram_.walks.walks[k];
      const DiagramGraph::Walk& own = index_.graph().walks[k];
      walks.push_back({walk.first, walk.last, own.first, own.last});
    }
    all["walks"] = lists(walks);
  }

  void put_events(nb::dict& all) const {
    std::string kinds;
    for (const DiagramEvent& event : diagram_.events) {
      kinds += "cjsrm"[static_cast<std::size_t>(event.kind)];
    }
    all["kinds"] = kinds;
    all["places"] = places_;
    all["near"] = lists(near_);
    Rows<2> gaps;
    for (const HullGap& gap : diagram_.gaps) gaps.push_back({gap.from, gap.to});
    all["gaps"] = lists(gaps);
  }

  void put_parts(nb::dict& all) const {
    Rows<5> halves;
    std::vector<double> motions;
    const std::vector<DiagramHalf>& own = index_.graph().halves;
    for (std::uint32_t k = 0; k < own.size(); ++k) {
      halves.push_back({own[k].from, own[k].to, own[k].twin, own[k].from_side, own[k].to_side});
      if (own[k].twin < k) continue;
      const CornerMotion m = corner_motion(diagram_, index_.graph(), k);
      for (const double value : {unit_ * m.ax, unit_ * m.ay, unit_ * m.r, unit_ * m.r_low, m.bx,
                                 m.by, unit_ * m.k0, m.k1, m.cx, m.cy}) {
        motions.push_back(value);
      }
    }
    all["halves"] = lists(halves);
    all["motions"] = motions;
    Numbers numbers;
    const DiagramGraph& graph = index_.graph();
    for (std::uint32_t k = 0; k < graph.events + graph.gaps + graph.reflex_vertices; ++k) {
      numbers.push_back(index_.radius_number(k));
    }
    all["numbers"] = numbers;
  }

  void put_history(nb::dict& all) const {
    const auto event = [](std::uint32_t number) -> nb::object {
      if (number == DiagramGraph::none) return nb::none();
      return nb::int_(number);
    };
    nb::list holes, joins;
    for (const OffsetHole& hole : self_.history.all_holes) {
      holes.append(
          nb::make_tuple(hole.birth, hole.end, event(hole.born_at), hole.ends_at, hole.from));
    }
    all["holes"] = holes;
    for (const ComponentJoin& join : self_.history.joins) {
      joins.append(
          nb::make_tuple(join.radius, join.at_radius ? 1 : 0, event(join.event), join.a, join.b));
    }
    all["joins"] = joins;
    all["polygons"] = self_.history.polygons;
  }

  const BoundIndex& self_;
  const DiscIndex& index_;
  const DiagramEvents& diagram_;
  double unit_;                                                    ///< a power of two
  std::vector<double> radii_, places_;                             ///< of events
  std::vector<Numbers> near_;                                      ///< features of events
  std::vector<std::pair<VertexId, std::uint32_t>> further_edges_;  ///< and their lines
};

/// The sum at one radius, and the radii of events.
void bind_index_radii(nb::class_<BoundIndex>& bound) {
  bound.def("__len__", [](const BoundIndex& self) { return self.index.radii(); })
      .def_ro("seconds", &BoundIndex::seconds, "Of the build.")
      .def_prop_ro("exact_signs",
                   [](const BoundIndex& self) { return self.index.diagram().exact_signs; })
      .def_prop_ro(
          "parts", [](const BoundIndex& self) { return self.index.graph().halves.size() / 2; },
          "Of the outer Voronoi diagram, on each of which the radius grows or shrinks.")
      .def(
          "radii", [](const BoundIndex& self) { return self.radii(); }, Released(),
          "Bounds of the radii of events, ascending, each once.")
      .def(
          "counts",
          [](const BoundIndex& self, const std::string& squared_radius) {
            const auto place = self.index.place(self.square(squared_radius));
            return std::pair(self.history.components(place), self.history.holes(place));
          },
          "squared_radius"_a, Released(), "(components, holes) at a radius, exact, events too.")
      .def(
          "measures",
          [](const BoundIndex& self, const std::string& squared_radius) {
            const Rational square = self.square(squared_radius);
            const OffsetMeasures found = self.measures_at(square);
            return std::pair(std::pair(found.area.lower(), found.area.upper()),
                             std::pair(found.length.lower(), found.length.upper()));
          },
          "squared_radius"_a, Released(),
          "Area and length of the boundary, each between two doubles, without the boundary.")
      .def(
          "at_event",
          [](const BoundIndex& self, const std::string& squared_radius) {
            return self.index.place(self.square(squared_radius)).at_event;
          },
          "squared_radius"_a, Released(), "Whether a radius is that of an event. Exact.")
      .def(
          "place",
          [](const BoundIndex& self, const std::string& squared_radius) {
            const auto place = self.index.place(self.square(squared_radius));
            return std::pair(place.gap, place.at_event);
          },
          "squared_radius"_a, Released(),
          "How many radii of events are not above a radius; whether the last is this one. Exact.")
      .def(
          "canonical_json",
          [](const BoundIndex& self, const std::string& squared_radius) {
            const Rational square = self.square(squared_radius);
            const auto place = self.index.place(square);
            if (place.at_event) return canonical_json(offset_region(self.P, square));
            return canonical_json(self.regions.at(place.gap).form, self.curves, square);
          },
          "squared_radius"_a, Released(),
          "The canonical form: read off, or at the radius of an event the static sum.")
      .def(
          "vertices",
          [](const BoundIndex& self, double radius) {
            auto found = std::make_unique<Vertices>();
            {
              const Computing computing;
              find_vertices(self, radius, *found);
              refuse_beyond_doubles(*found);
            }
            return as_arrays(std::move(found));
          },
          "radius"_a, nb::sig("def vertices(self, radius: float) -> tuple[typing.Any, typing.Any]"),
          "x, y and a bound of the error of each vertex of the boundary, ring by ring, the sum on "
          "the left; and where rings start. At the radius of an event those just above.");
}

/// The events, the diagram between them, and the changes at them.
void bind_index_events(nb::class_<BoundIndex>& bound) {
  bound
      .def(
          "rows",
          [](const BoundIndex& self, std::size_t first, std::size_t count) {
            return diagram_rows(self.index.diagram(), first, count);
          },
          "first"_a, "count"_a, Released(), "Events as DiagramEvents.rows has them.")
      .def(
          "kinds",
          [](const BoundIndex& self) {
            std::vector<std::string> kinds;
            for (const DiagramEvent& event : self.index.diagram().events) {
              kinds.emplace_back(name(event.kind));
            }
            return kinds;
          },
          Released(), "Of all events, in order.")
      .def(
          "graph", &graph_parts, Released(),
          "Parts of the outer Voronoi diagram: their ends, (\"event\", [number]), (\"vertex\", [x, "
          "y]) of a reflex vertex, or (\"infinity\", [x, y, x, y]) between two vertices of the "
          "hull; and the two features that are nearest.")
      .def(
          "places", &place_rows, Released(),
          "Three features, by number, and a branch, for each event of three features or more: what "
          "disc_index proves again.")
      .def("changes", &changes, Released(),
           "(event, number of its radius from 1 on, holes that are born and the hole that each was "
           "a part of, holes that end, polygons whose components join), of events at which there "
           "are any.")
      .def("holes", &holes, Released(),
           "(birth or None, end, place of the end, hole that it was a part of), numbered from 1.")
      .def("joins", &joins, Released(),
           "(radius or None, polygon, polygon): from where on components are one.")
      .def(
          "drawing", [](const BoundIndex& self) { return Drawing(self).fields(); },
          nb::sig("def drawing(self) -> dict[str, typing.Any]"),
          "The boundary of P and the outer Voronoi diagram, in doubles: what the page of `minkref "
          "view P disc` has. Its fields are those of docs/command-line.md.")
      .def(
          "seconds_of_queries",
          [](const BoundIndex& self, const std::vector<double>& radii, unsigned rounds) {
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
}

}  // namespace

void bind_disc_index(nb::module_& module) {
  nb::class_<BoundIndex> bound(module, "DiscIndex", "P + a disc at all radii.");
  bind_index_radii(bound);
  bind_index_events(bound);
  module.def(
      "disc_index",
      [](const Set& P, unsigned threads,
         const std::optional<std::vector<PlaceRow>>& places) -> BoundIndex* {
        const Stopwatch watch;
        auto index = std::make_unique<BoundIndex>(P.value, diagram_of(P.value, threads, places));
        index->seconds = watch.seconds();
        return index.release();
      },
      "P"_a, "threads"_a = 1, "places"_a = nb::none(), Released(),
      "P + a disc about the origin at all radii. `places`: what DiscIndex.places says of the same "
      "set: they are proven again, not trusted. Raises BadInput, LimitExceeded.");
}

}  // namespace minkref::python
