// The paper's own update of a sum in space for Python.
#include "bindings/core_paper_space_update.hpp"

#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/core_readings.hpp"
#include "bindings/core_space.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/paper/trials/space_sum_trial.hpp"
#include "reference/space/edges/edge_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Counts = std::map<std::string, std::uint64_t>;
using RingRow = std::vector<ExactSpacePoint>;
/// A count, and the seconds spent.
using Found = std::pair<std::size_t, double>;
/// Normal, offset.
using Plane = std::pair<ExactSpacePoint, std::string>;
/// Whether the structure is the exact one; the largest error and the largest coordinate; a point,
/// its plane, and whether it is on the boundary.
using TrialRow = std::tuple<bool, std::string, std::string,
                            std::optional<std::tuple<ExactSpacePoint, Plane, bool>>>;

struct AnsweredSum {
  PaperSpaceSum sum;
  double seconds;

  Counts counts() const {
    Counts counts{{"exposed_facets", sum.exposed.size()},
                  {"cells", sum.cells.size()},
                  {"nodes", sum.nodes},
                  {"asked", sum.asked}};
    for (const auto& cell : sum.cells) counts["exposed_cells"] += cell.exposed;
    for (const auto& part : sum.exposed) {
      counts["rings"] += part.rings.size();
      for (const auto& ring : part.rings) counts["corners"] += ring.size();
    }
    return counts;
  }

  std::vector<std::pair<std::uint32_t, std::vector<RingRow>>> facets() const {
    std::vector<std::pair<std::uint32_t, std::vector<RingRow>>> rows;
    for (const auto& part : sum.exposed) {
      auto& rings = rows.emplace_back(part.facet, std::vector<RingRow>{}).second;
      for (const auto& ring : part.rings) {
        RingRow& row = rings.emplace_back();
        for (const SpacePoint& corner : ring) row.push_back(to_strings(corner));
      }
    }
    return rows;
  }
};

class SpaceUpdate {
 public:
  SpaceUpdate(const Surface& P, const Surface& Q, const std::string& scale,
              const std::string& arithmetic, const Words& readings, unsigned threads,
              const std::optional<Progress>& progress)
      : P_(P.value()), Q_(Q.value()), scale_(parse_rational(scale)) {
    const Stopwatch watch;
    update_ = PaperSpaceUpdate::make(P_, Q_, scale_, arithmetic,
                                     readings_of<SpaceUpdateReadings>(readings),
                                     build_on(threads, progress));
    seconds = watch.seconds();
  }

  std::pair<Counts, double> move_to(const std::string& scale) {
    const Rational to = parse_rational(scale);
    const Stopwatch watch;
    const PaperSpaceUpdate::Step step = update_->move_to(to);
    const double taken = watch.seconds();
    scale_ = to;
    return {
        {{"insertions", step.insertions}, {"deletions", step.deletions}, {"updated", step.updated}},
        taken};
  }

  Found place_intersections() {
    const Stopwatch watch;
    const std::size_t count = update_->place_intersections();
    return {count, watch.seconds()};
  }

  Found search_intersections(const std::string& scale, bool near) const {
    using Pairs = PaperSpaceUpdate::Pairs;
    const Rational at = parse_rational(scale);
    const Stopwatch watch;
    const std::size_t count = update_->search_intersections(at, near ? Pairs::near : Pairs::all);
    return {count, watch.seconds()};
  }

  AnsweredSum sum(const std::optional<Progress>& progress) {
    const Stopwatch watch;
    PaperSpaceSum found = update_->sum(build_on(1, progress));
    return {std::move(found), watch.seconds()};
  }

  TrialRow beside_exact(const AnsweredSum& answer, const std::string& limit, unsigned threads,
                        const std::optional<Progress>& progress) const {
    const BuildOptions options = build_on(threads, progress);
    const PaperSpaceSum truth = facet_sum_at(P_, Q_, scale_, options);
    const PolyhedralSet exact = edge_sum(P_, Q_, {scale_, scale_, scale_}, options).set;
    const SpaceSumTrial trial =
        space_sum_trial(*update_, scale_, answer.sum, truth, exact, parse_rational(limit));
    TrialRow row{trial.same_structure, to_string(trial.error), to_string(trial.coordinate), {}};
    if (trial.witness) {
      const auto& [point, plane, on_boundary] = *trial.witness;
      const ExactSpacePoint normal{plane.normal[0].str(), plane.normal[1].str(),
                                   plane.normal[2].str()};
      std::get<3>(row) = {to_strings(point), {normal, to_string(plane.offset)}, on_boundary};
    }
    return row;
  }

  Counts event_trial(const SpaceUpdate& truth, long bits) const {
    const SpaceEventTrial trial =
        space_event_trial(truth.update_->events(), update_->events(), bits);
    return {{"events", trial.events},
            {"right", trial.right},
            {"misplaced", trial.misplaced},
            {"missed", trial.missed},
            {"invented", trial.invented}};
  }

  std::vector<std::string> event_scales() const {
    std::vector<std::string> scales;
    for (const auto& event : update_->events()) scales.push_back(to_string(event.scale));
    return scales;
  }

  Counts counts() const {
    const PaperSpaceUpdate::Counts counts = update_->counts();
    return {{"facets", counts.facets},
            {"pairs", counts.pairs},
            {"crossings", counts.crossings},
            {"events", counts.events},
            {"undecided", counts.undecided}};
  }

  double seconds = 0;

 private:
  const Polyhedron P_, Q_;
  Rational scale_;
  std::unique_ptr<PaperSpaceUpdate> update_;
};

void bind_answered_sum(nb::module_& module) {
  nb::class_<AnsweredSum>(module, "PaperSpaceSum",
                          "A sum in space as the paper's program answers in one arithmetic: the "
                          "exposed part of each facet of the convolution.")
      .def("counts", &AnsweredSum::counts,
           "Facets that are exposed, their rings and corners; cells of the facets' arrangements, "
           "cells that are exposed, nodes, cells that collision detection was asked about.")
      .def("facets", &AnsweredSum::facets, Released(),
           "(facet's number, rings) for each exposed facet; every node of the arrangement on a "
           "ring is a corner, with the arithmetic's coordinates, exactly.")
      .def(
          "set", [](const AnsweredSum& answer) { return answer.sum.set; }, Released(),
          "The set with this boundary, in rational numbers; None in other arithmetics.")
      .def_ro("seconds", &AnsweredSum::seconds, "That arrangements and collision detection took.");
}

}  // namespace

void bind_paper_space_update(nb::module_& module) {
  bind_answered_sum(module);
  nb::class_<SpaceUpdate>(module, "PaperSpaceUpdate",
                          "The paper's program of Section 5: sP + Q of polyhedra followed from one "
                          "scale to another in one arithmetic, each sentence as read.")
      .def(nb::init<const Surface&, const Surface&, const std::string&, const std::string&,
                    const Words&, unsigned, const std::optional<Progress>&>(),
           "P"_a, "Q"_a, "scale"_a = "1", "arithmetic"_a = "rational", "readings"_a = Words{},
           "threads"_a = 1, "progress"_a = nb::none(), Released(),
           "Finds the crossings of all pairs of facets of the reduced convolution, and the list at "
           "the first scale, for valid solids. `arithmetic`: rational, interval, double, "
           "mpfr:BITS. `readings`: as `space_update_readings` lists them; those left out are the "
           "printed ones. `threads`: that look for the crossings; the answers do not depend on it. "
           "`progress` is told how many of how many facets are done. "
           "O(N^2) for N facets. Raises BadInput, LimitExceeded, UndecidedSign.")
      .def("move_to", &SpaceUpdate::move_to, "scale"_a, Released(),
           "Steps through the events to this scale: insertions, deletions, crossings updated; "
           "seconds.")
      .def("place_intersections", &SpaceUpdate::place_intersections, Released(),
           "Places all crossings on the list where the walk stands: how many, seconds.")
      .def("search_intersections", &SpaceUpdate::search_intersections, "scale"_a, "near"_a = false,
           Released(),
           "Finds the crossings at a scale without the list, from all pairs of facets in the same "
           "arithmetic, or from those whose boxes meet (`near`): how many, those at common corners "
           "included, and seconds.")
      .def("sum", &SpaceUpdate::sum, "progress"_a = nb::none(), Released(),
           "The sum where the walk stands, as this arithmetic answers. `progress` is told how many "
           "of how many facets are done.")
      .def("beside_exact", &SpaceUpdate::beside_exact, "answer"_a, "limit"_a, "threads"_a = 1,
           "progress"_a = nb::none(), Released(),
           "Holds the answer where the walk stands against the exact sum: whether as many facets "
           "are exposed, each with as many rings and corners, with no corner off by more than "
           "`limit` in parts of the largest coordinate; the largest error; the largest coordinate; "
           "and where they differ a point, its plane (normal, offset), and whether the point is on "
           "the boundary, or None. `progress` is told three times, of the exact sum's crossings, "
           "of its facets, and of the set's edges.")
      .def("event_trial", &SpaceUpdate::event_trial, "truth"_a, "bits"_a, Released(),
           "Counts of events in truth, and of right, misplaced, missed and invented ones here; "
           "`bits` of the numbers here, 0 for exact ones.")
      .def(
          "event_scales", &SpaceUpdate::event_scales, Released(),
          "The scale of each event of the array, ascending; the scales of the arithmetic, exactly.")
      .def("counts", &SpaceUpdate::counts,
           "Facets, pairs looked at, crossings, events, pairs left out for NaN.")
      .def_ro("seconds", &SpaceUpdate::seconds, "That finding the crossings took.");
  bind_reading_check<SpaceUpdateReadings>(module, "check_space_update_reading");
  module.def(
      "space_update_readings", [] { return rows_of(space_update_reading_names()); },
      "The choices of a PaperSpaceUpdate: name, values (the printed one first), the corrected one, "
      "section of the paper.");
}

}  // namespace minkref::python
