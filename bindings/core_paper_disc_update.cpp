// The Appendix's own program for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_readings.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/paper/disc/disc_update.hpp"
#include "reference/paper/disc/disc_witness.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// A count, and the seconds spent.
using Found = std::pair<std::size_t, double>;
/// "edge", its ring and the index of its first vertex; "vertex" and its coordinates.
using ParentRow = std::tuple<std::string, std::string, std::string>;
/// Parent; P's points at the ends (of an arc the centre, twice); the outward normals there, in
/// coprime integers; both ends as the nearest doubles.
using CurveRow =
    std::tuple<ParentRow, std::pair<ExactPoint, ExactPoint>, std::pair<ExactPoint, ExactPoint>,
               std::pair<std::pair<double, double>, std::pair<double, double>>>;
/// The scale between two doubles, two features by number, the branch, whether segments lie on one
/// line, whether they begin to meet.
using EventRow = std::tuple<double, double, std::uint32_t, std::uint32_t, int, bool, bool>;

ParentRow parent(const OffsetFeature& feature) {
  if (feature.is_arc) {
    return {"vertex", to_string(feature.at[0].x), to_string(feature.at[0].y)};
  }
  return {"edge", std::to_string(feature.id.ring), std::to_string(feature.id.index)};
}

std::vector<ParentRow> parents(const std::vector<OffsetFeature>& features) {
  std::vector<ParentRow> rows;
  for (const OffsetFeature& feature : features) rows.push_back(parent(feature));
  return rows;
}

std::pair<double, double> end_of(const OffsetFeature& feature, std::size_t k,
                                 const Rational& squared_radius) {
  const Direction& way = feature.way[k];
  const RootNumber out = sqrt(RootNumber(Rational(squared_radius / dot(way, way))));
  return {nearest_double(RootNumber(feature.at[k].x) + out * RootNumber(way.x)),
          nearest_double(RootNumber(feature.at[k].y) + out * RootNumber(way.y))};
}

std::vector<CurveRow> disc_convolution(const Set& P, const std::string& squared_radius) {
  const Rational square = parse_rational(squared_radius);
  std::vector<CurveRow> rows;
  for (const OffsetFeature& feature : offset_features(offset_curves(P.value))) {
    const auto normal = [&](std::size_t k) -> ExactPoint {
      const Direction way = primitive(feature.way[k]);
      return {to_string(way.x), to_string(way.y)};
    };
    rows.emplace_back(parent(feature),
                      std::pair{to_strings(feature.at[0]), to_strings(feature.at[1])},
                      std::pair{normal(0), normal(1)},
                      std::pair{end_of(feature, 0, square), end_of(feature, 1, square)});
  }
  return rows;
}

struct AppendixAnswer {
  DiscAnswer found;
  std::string canonical;
  double seconds = 0;
};

/// Not `Update`: the extension module knows types by their names.
class AppendixUpdate {
 public:
  AppendixUpdate(const Set& P, const std::string& squared_radius, const std::string& squared_unit,
                 const std::string& arithmetic, const Words& readings)
      : P_(P.value) {
    DiscUpdate::Options options{parse_rational(squared_unit), arithmetic,
                                readings_of<AppendixReadings>(readings), memory_limit()};
    const Stopwatch watch;
    update_ = DiscUpdate::make(P_, parse_rational(squared_radius), options);
    seconds = watch.seconds();
  }

  Fields move_to(const std::string& squared_radius) {
    const Rational to = parse_rational(squared_radius);
    DiscUpdate::Step step;
    double taken = 0;
    {
      const Computing computing;
      const Stopwatch watch;
      step = update_->move_to(to);
      taken = watch.seconds();
    }
    Fields fields;
    MINKREF_PUT(step, insertions, deletions, updated);
    fields["seconds"] = taken;
    return fields;
  }

  Found place_intersections() {
    const Stopwatch watch;
    const std::size_t count = update_->place_intersections();
    return {count, watch.seconds()};
  }

  Found search_intersections(const std::string& squared_radius) const {
    const Rational at = parse_rational(squared_radius);
    const Stopwatch watch;
    const std::size_t count = update_->search_intersections(at);
    return {count, watch.seconds()};
  }

  AppendixAnswer answer() {
    const Stopwatch watch;
    DiscAnswer found = update_->answer();
    const double taken = watch.seconds();
    std::string canonical = canonical_json(found, *update_);
    return {std::move(found), std::move(canonical), taken};
  }

  std::optional<std::pair<ExactPoint, bool>> witness(const AppendixAnswer& answer) const {
    const auto found = disc_witness(P_, update_->squared_radius(), answer.found);
    if (!found) return std::nullopt;
    return std::pair{to_strings(found->point), found->in_sum};
  }

  std::vector<EventRow> events(std::size_t first, std::size_t most) const {
    std::vector<EventRow> rows;
    const std::vector<DiscUpdate::Event> all = update_->events();
    for (std::size_t k = first; k < all.size() && k - first < most; ++k) {
      const DiscUpdate::Event& event = all[k];
      rows.emplace_back(event.low, event.high, event.a, event.b, event.branch, event.is_overlap,
                        event.insertion);
    }
    return rows;
  }

  Fields agreement(const AppendixUpdate& truth, long bits) const {
    DiscUpdate::Agreement found;
    {
      const Computing computing;
      found = update_->agreement(*truth.update_, bits);
    }
    Fields fields;
    MINKREF_PUT(found, right, misplaced, missed, invented);
    return fields;
  }

  Fields counts() const {
    const DiscUpdate::Counts counts = update_->counts();
    Fields fields;
    MINKREF_PUT(counts, segments, arcs, pairs, meetings, undecided);
    return fields;
  }

  std::vector<ParentRow> features() const { return parents(update_->features()); }

  double seconds = 0;

 private:
  PolygonSet P_;
  std::unique_ptr<DiscUpdate> update_;
};

}  // namespace

void bind_paper_disc_update(nb::module_& module) {
  nb::class_<AppendixAnswer>(module, "DiscAnswer",
                             "What the Appendix's program answers at one radius: rings of curves.")
      .def_ro("canonical", &AppendixAnswer::canonical, "The canonical form, as that of an Offset.")
      .def_prop_ro("components",
                   [](const AppendixAnswer& answer) { return answer.found.components; })
      .def_prop_ro("holes", [](const AppendixAnswer& answer) { return answer.found.holes; })
      .def_prop_ro(
          "statistics",
          [](const AppendixAnswer& answer) {
            const DiscAnswer& found = answer.found;
            Fields fields;
            MINKREF_PUT(found, nodes, faces, asked);
            return fields;
          },
          "Nodes and faces of the arrangement, and faces with a collision test.")
      .def(
          "corner_distance",
          [](const AppendixAnswer& answer, const AppendixAnswer& other) {
            return corner_distance(answer.found, other.found);
          },
          "other"_a, Released(),
          "The largest distance of corresponding corners, rounded; None unless all curves of all "
          "rings agree.")
      .def_ro("seconds", &AppendixAnswer::seconds);
  nb::class_<AppendixUpdate>(
      module, "DiscUpdate",
      "The program of the paper's Appendix: P + sQ with a disc Q, followed from one "
      "radius to another in one arithmetic, each sentence as read.")
      .def(nb::init<const Set&, const std::string&, const std::string&, const std::string&,
                    const Words&>(),
           "P"_a, "squared_radius"_a, "squared_unit"_a = "1", "arithmetic"_a = "rational",
           "readings"_a = Words{}, Released(),
           "Finds the scales at which two segments or arcs meet, for all pairs, and starts at the "
           "first radius. `squared_unit`: of Q at the scale 1. `arithmetic`: rational (with square "
           "roots: exact), double, mpfr:BITS. `readings`: as `appendix_readings` lists them; those "
           "left out are the printed ones. O(N^2) for N segments and arcs. Raises BadInput.")
      .def("move_to", &AppendixUpdate::move_to, "squared_radius"_a,
           "Steps through the events to this radius: insertions, deletions, intersections updated, "
           "seconds.")
      .def("place_intersections", &AppendixUpdate::place_intersections, Released(),
           "Places all intersections on the list where the walk stands: how many, seconds.")
      .def("search_intersections", &AppendixUpdate::search_intersections, "squared_radius"_a,
           Released(),
           "Finds the intersections at a radius without the list, from all pairs in the same "
           "arithmetic, the formulas in their right form: how many, seconds.")
      .def("answer", &AppendixUpdate::answer, Released(), "The sum where it stands, as it answers.")
      .def("witness", &AppendixUpdate::witness, "answer"_a, Released(),
           "A point that is in one only of the answer and the sum, and whether in the sum; None "
           "where none is found.")
      .def("events", &AppendixUpdate::events, "first"_a = 0, "count"_a = SIZE_MAX, Released(),
           "(two doubles around the scale, feature, feature, branch, whether on one line, whether "
           "they begin to meet), ascending.")
      .def("agreement", &AppendixUpdate::agreement, "truth"_a, "bits"_a,
           "Counts of right, misplaced, missed and invented events beside those of an exact "
           "program: right are those within 2^-bits of the scale.")
      .def("counts", &AppendixUpdate::counts,
           "Segments, arcs, pairs looked at, meetings, pairs left out for NaN.")
      .def("features", &AppendixUpdate::features, Released(),
           "By number: an edge, its ring and the index of its first vertex, or a vertex and its "
           "coordinates.")
      .def_ro("seconds", &AppendixUpdate::seconds, "That finding the meetings took.");
  module.def("disc_convolution", disc_convolution, "P"_a, "squared_radius"_a, Released(),
             "The segments and arcs of the reduced convolution with a disc: (parent, points of P "
             "at both ends, outward normals there, the ends as the nearest doubles).");
  bind_reading_check<AppendixReadings>(module, "check_appendix_reading");
  module.def(
      "appendix_readings", [] { return rows_of(appendix_reading_names()); },
      "The choices of a DiscUpdate: name, values (the printed one first), the corrected one, "
      "section of the paper.");
}

}  // namespace minkref::python
