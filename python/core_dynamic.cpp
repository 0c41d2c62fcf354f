// The dynamic sum in Python.
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "python/core.hpp"
#include "python/core_timed_sum.hpp"
#include "python/core_timeline.hpp"
#include "python/stopwatch.hpp"
#include "python/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/dynamic/event_list.hpp"
#include "reference/plane/dynamic/from_scratch.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// All arrangement events of a closed window.
class Arrangement {
 public:
  Arrangement(const Set& P, const Set& Q, const std::optional<std::string>& from,
              const std::optional<std::string>& to)
      : P_(P.value), Q_(Q.value) {
    const Stopwatch watch;
    const ScaleWindow window = window_of(from, to);
    refuse_bad_operands(P_, Q_, 1);
    refuse_large_convolution(P_, Q_);
    refuse_bad_window(window);
    if (!P_.empty() && !Q_.empty()) {
      events_ = std::make_unique<ArrangementEvents>(P_, Q_, opened(window));
      list_ = listed_events(*events_, window);
    }
    seconds = watch.seconds();
  }

  /// scale, kind, change, edges, at, to.
  using Row = std::tuple<std::string, std::string, std::string, std::vector<std::uint32_t>,
                         ExactPoint, std::optional<ExactPoint>>;

  std::vector<Row> rows(const std::vector<std::uint32_t>& which) const {
    std::vector<Row> result;
    for (const std::uint32_t i : which) result.push_back(row(list_.at(i)));
    return result;
  }

  /// Places in the list of the events of a kind: pair, parallel, triple or arrangement (all).
  std::vector<std::uint32_t> of_kind(const std::string& kind) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < list_.size(); ++i) {
      if (kind == "arrangement" || kind == name(list_[i])) result.push_back(i);
    }
    return result;
  }

  std::vector<EdgeRow> edges() const {
    return events_ ? convolution_rows(events_->edges()) : std::vector<EdgeRow>{};
  }

  /// Of each of these events, how many different scales of them lie below its own.
  std::vector<std::uint32_t> ranks(const std::vector<std::uint32_t>& which) const {
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < which.size(); ++i) {
      const bool same = i > 0 && list_[which[i]].group == list_[which[i - 1]].group;
      result.push_back(i == 0 ? 0 : result.back() + !same);
    }
    return result;
  }

  Fields counts() const {
    Fields fields;
    const PairEvents none;
    const PairEvents& pairs = events_ ? events_->pairs() : none;
    fields["pairs"] = pairs.pairs;
    fields["filtered_pairs"] = pairs.filtered_pairs;
    fields["s_edges"] = pairs.statistics.s_edges;
    fields["t_edges"] = pairs.statistics.t_edges;
    fields["kernel"] = pairs.statistics.kernel;
    std::uint64_t swaps = 0;
    for (const ListedEvent& event : list_) {
      if (event.kind != ListedEvent::Kind::triple) continue;
      const unsigned bits = events_->triples()[event.index].swaps;
      swaps += (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1);
    }
    fields["node_swaps"] = swaps;
    return fields;
  }

  double seconds = 0;

 private:
  std::string name(const ListedEvent& event) const {
    if (event.kind == ListedEvent::Kind::triple) return "triple";
    if (event.kind == ListedEvent::Kind::passing) return "parallel";
    return events_->pairs().events[event.index].parallel ? "parallel" : "pair";
  }

  Row row(const ListedEvent& event) const {
    if (event.kind == ListedEvent::Kind::pair) {
      const PairEvent& pair = events_->pairs().events[event.index];
      const auto place =
          event_places(events_->pairs(), event.index, event.index + 1, events_->moving()).front();
      static constexpr std::array<const char*, 4> changes{"birth", "death", "touch", "overlap"};
      return {to_string(place.scale),
              name(event),
              changes.at(static_cast<std::size_t>(pair.change)),
              {pair.a, pair.b},
              to_strings(place.at),
              place.to ? std::optional(to_strings(*place.to)) : std::nullopt};
    }
    const Rational scale = events_->exact(event.group);
    const auto at = [&](std::uint32_t edge, std::uint32_t node) {
      return to_strings(node_track(*events_, edge, node).at(scale));
    };
    if (event.kind == ListedEvent::Kind::triple) {
      const TripleEvent& triple = events_->triples()[event.index];
      return {to_string(scale),
              "triple",
              "swap",
              {triple.a, triple.b, triple.c},
              at(triple.edge, triple.first),
              std::nullopt};
    }
    const std::uint32_t other = events_->table().nodes[event.index].other;
    return {to_string(scale),
            "parallel",
            "swap",
            {std::min(event.edge, other), std::max(event.edge, other)},
            at(event.edge, event.index),
            std::nullopt};
  }

  PolygonSet P_, Q_;
  std::unique_ptr<ArrangementEvents> events_;
  std::vector<ListedEvent> list_;
};

/// The dynamic sum, with its topology once asked for.
class Dynamic {
 public:
  Dynamic(const Set& P, const Set& Q, const std::optional<std::string>& from,
          const std::optional<std::string>& to)
      : P_(P.value), Q_(Q.value) {
    refuse_large_convolution(P_, Q_);
    const Stopwatch watch;
    sum_ = std::make_unique<DynamicSum>(P.value, Q.value, window_of(from, to));
    seconds = watch.seconds();
  }

  Fields move_to(const std::string& scale) {
    const Rational s = parse_rational(scale);
    const Stopwatch watch;
    const StepReport report = sum_->move_to(s);
    const double taken = watch.seconds();
    Fields fields;
    fields["insertions"] = report.insertions;
    fields["deletions"] = report.deletions;
    fields["swaps"] = report.swaps;
    fields["updated"] = report.updated;
    fields["groups"] = report.groups;
    fields["seconds"] = taken;
    return fields;
  }

  /// Moves, and gives the positions of all nodes in doubles: seconds for the two.
  double update(const std::string& scale) {
    const Rational s = parse_rational(scale);
    const Stopwatch watch;
    sum_->move_to(s);
    if (!sum_->empty()) sum_->arrangement().positions(positions_);
    return watch.seconds();
  }

  std::string difference_from_scratch() { return minkref::difference_from_scratch(*sum_, P_, Q_); }

  /// All scales of arrangement events within the window, each with the kinds of its events.
  std::vector<std::pair<std::string, std::vector<std::string>>> event_scales() const {
    std::vector<std::pair<std::string, std::vector<std::string>>> rows;
    if (sum_->empty()) return rows;
    std::uint32_t last = EdgeNode::always;
    for (const ListedEvent& event : listed_events(events(), sum_->window())) {
      if (event.group != last)
        rows.emplace_back(scale_text(event.group), std::vector<std::string>{});
      last = event.group;
      const bool pair =
          event.kind == ListedEvent::Kind::pair && !events().pairs().events[event.index].parallel;
      const std::string kind = event.kind == ListedEvent::Kind::triple ? "triple"
                               : pair                                  ? "pair"
                                                                       : "parallel";
      auto& kinds = rows.back().second;
      if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    }
    return rows;
  }

  using LifeRow = TimelineRows::LifeRow;
  std::vector<LifeRow> lives(const std::string& kind) { return rows().lives(kind); }

  TimedSum sum() {
    const Stopwatch watch;
    Sum sum = sum_->sum();
    return {{std::move(sum.region), true}, sum.components, sum.holes, watch.seconds(),
            std::move(sum.statistics),     std::nullopt};
  }

  Fields counts() const {
    Fields fields;
    if (sum_->empty()) return fields;
    const ArrangementTimeline& timeline = sum_->states().timeline();
    const ArrangementEvents& events = *timeline.events;
    fields["s_edges"] = events.pairs().statistics.s_edges;
    fields["t_edges"] = events.pairs().statistics.t_edges;
    fields["kernel"] = events.pairs().statistics.kernel;
    fields["pair_events"] = events.pairs().events.size();
    fields["triple_events"] = events.triples().size();
    fields["scales"] = events.groups();
    fields["node_changes"] = timeline.changes.size();
    fields["sub_edges"] = timeline.sub_edges.size();
    fields["tracks"] = sum_->states().tracks().size();
    fields["boundary_groups"] = sum_->states().groups().size();
    fields["decided_by_doubles"] = timeline.decided_by_doubles;
    fields["decided_exactly"] = timeline.decided_exactly;
    return fields;
  }

  std::vector<EdgeRow> edges() const {
    if (sum_->empty()) return {};
    return convolution_rows(sum_->states().timeline().events->edges());
  }

  std::vector<TimelineRows::BoundaryRow> boundary_events() { return rows().boundary_events(); }
  std::vector<TimelineRows::TopologyRow> topology_events() { return rows().topology_events(); }
  std::vector<TimelineRows::FeatureRow> features(const std::string& kind) {
    return rows().features(kind);
  }
  std::vector<TimelineRows::CountRow> state_counts() { return rows().state_counts(); }

  /// The point a + s b of each track, exact: (ax, ay), (bx, by).
  std::vector<std::pair<ExactPoint, ExactPoint>> tracks() const {
    std::vector<std::pair<ExactPoint, ExactPoint>> rows;
    if (sum_->empty()) return rows;
    for (const Track& track : sum_->states().tracks()) {
      rows.emplace_back(to_strings(track.a), to_strings(track.b));
    }
    return rows;
  }

  void ring_states(const std::function<void(TimelineRows::RingState)>& report) {
    if (sum_->empty()) return;
    topology_timeline(sum_->states(), [&](RingsFrom state) {
      TimelineRows::RingState row;
      if (state.interval > 0) row.first = scale_text(state.interval - 1);
      for (BoundaryRing& ring : state.rings) {
        row.second.emplace_back(ring.is_hole, ring.component, ring.hole, std::move(ring.vertices));
      }
      report(std::move(row));
    });
  }

  double seconds = 0;

 private:
  TimelineRows rows() {
    if (!topology_) {
      topology_ = sum_->empty() ? TopologyTimeline{} : topology_timeline(sum_->states());
    }
    return {*topology_, sum_->window(),
            [this](std::uint32_t group) { return events().exact(group); }};
  }
  const ArrangementEvents& events() const { return *sum_->states().timeline().events; }
  std::string scale_text(std::uint32_t group) const { return to_string(events().exact(group)); }

  PolygonSet P_, Q_;
  std::unique_ptr<DynamicSum> sum_;
  std::optional<TopologyTimeline> topology_;
  std::vector<double> positions_;
};

}  // namespace

void bind_dynamic(nb::module_& module) {
  using OptionalText = std::optional<std::string>;
  nb::class_<Arrangement>(module, "ArrangementEvents",
                          "Pair, parallel and triple events of sP + Q in a closed window, sorted.")
      .def(nb::init<const Set&, const Set&, const OptionalText&, const OptionalText&>(), "P"_a,
           "Q"_a, "from_scale"_a = nb::none(), "to_scale"_a = nb::none(), Released())
      .def_ro("seconds", &Arrangement::seconds)
      .def("counts", &Arrangement::counts)
      .def("edges", &Arrangement::edges, Released(), "Rows as reduced_convolution's.")
      .def("of_kind", &Arrangement::of_kind, "kind"_a, Released(),
           "The places of pair, parallel, triple or all (arrangement) events in the list.")
      .def("ranks", &Arrangement::ranks, "which"_a, Released(),
           "Events of equal scale have equal rank; ranks count from 0.")
      .def("rows", &Arrangement::rows, "which"_a, Released(),
           "(scale, kind, change, edges, at, to) of these events, exact.");
  nb::class_<Dynamic>(module, "DynamicSum",
                      "sP + Q over a closed window of scales, by dynamic update.")
      .def(nb::init<const Set&, const Set&, const OptionalText&, const OptionalText&>(), "P"_a,
           "Q"_a, "from_scale"_a = nb::none(), "to_scale"_a = nb::none(), Released())
      .def_ro("seconds", &Dynamic::seconds, "Of finding all events.")
      .def("counts", &Dynamic::counts)
      .def("edges", &Dynamic::edges, Released())
      .def("move_to", &Dynamic::move_to, "scale"_a,
           "Steps to a scale: insertions, deletions, swaps, updated nodes, groups of events.")
      .def("update", &Dynamic::update, "scale"_a, Released(),
           "Steps to a scale and places all nodes, in doubles; gives the seconds.")
      .def("sum", &Dynamic::sum, Released(), "The sum where it stands, exact.")
      .def("boundary_events", &Dynamic::boundary_events, Released(),
           "(scale, change, edges, place), ascending.")
      .def("topology_events", &Dynamic::topology_events, Released(),
           "(scale, feature, change, before, after, parts at the scale, place), ascending.")
      .def("features", &Dynamic::features, "kind"_a, Released(),
           "Scales of birth and death of each hole (0 is the outside) or component.")
      .def("lives", &Dynamic::lives, "kind"_a, Released(),
           "Holes (the outside left out) or components that live within the window: name, scales "
           "of birth and death.")
      .def("event_scales", &Dynamic::event_scales, Released(),
           "All scales of arrangement events: (scale, kinds), ascending.")
      .def("difference_from_scratch", &Dynamic::difference_from_scratch, Released(),
           "What differs from the static arrangement and sum at the same scale; empty: nothing.")
      .def("state_counts", &Dynamic::state_counts, Released(),
           "States of the boundary: where each begins, (holes, components, vertices, holes and "
           "components at the scale itself).")
      .def("tracks", &Dynamic::tracks, Released(), "The point a + s b of each track: a, b.")
      .def("ring_states", &Dynamic::ring_states, "report"_a,
           "Calls report with each state of the boundary: where it begins, and its rings as (is a "
           "hole's, component, hole, tracks).");
}

}  // namespace minkref::python
