// The dynamic sum for Python.
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/paper/trials/from_scratch.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/dynamic/event_list.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// The dynamic sum, with its topology once asked for.
class Dynamic {
 public:
  Dynamic(const Set& P, const Set& Q, const std::optional<std::string>& from,
          const std::optional<std::string>& to, const std::string& route)
      : P_(P.value), Q_(Q.value) {
    const ConvolutionType of = convolution_followed(route);
    refuse_large_convolution(P_, Q_, of == ConvolutionType::full);
    const Stopwatch watch;
    sum_ = std::make_unique<DynamicSum>(P.value, Q.value, window_of(from, to), of);
    seconds = watch.seconds();
  }

  Fields move_to(const std::string& scale) {
    const Rational s = parse_rational(scale);
    const Stopwatch watch;
    const StepReport report = computed([&] { return sum_->move_to(s); });
    const double taken = watch.seconds();
    at_ = s;
    Fields fields;
    MINKREF_PUT(report, insertions, deletions, swaps, updated, groups);
    fields["seconds"] = taken;
    return fields;
  }

  /// Moves, and gives the positions of all nodes in doubles: seconds for the two.
  double update(const std::string& scale) {
    const Rational s = parse_rational(scale);
    const Stopwatch watch;
    sum_->move_to(s);
    at_ = s;
    if (!sum_->empty()) sum_->arrangement().positions(positions_);
    return watch.seconds();
  }

  std::string difference_from_scratch() { return minkref::difference_from_scratch(*sum_, P_, Q_); }

  /// All scales of arrangement events within the window, with the kinds of events at each.
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
    const double taken = watch.seconds();
    LaterPassages passages;
    if (at_) passages = LaterPassages([this, at = *at_] { return tight_passages(P_, Q_, at); });
    return {{std::move(sum.region), true}, sum.components,     sum.holes, taken,
            std::move(sum.statistics),     std::move(passages)};
  }

  Fields counts() const {
    Fields fields;
    if (sum_->empty()) return fields;
    const ArrangementTimeline& timeline = sum_->states().timeline();
    const ArrangementEvents& events = *timeline.events;
    MINKREF_PUT(events.pairs().statistics, s_edges, t_edges, kernel);
    fields["pair_events"] = events.pairs().events.size();
    fields["triple_events"] = events.triples().size();
    fields["scales"] = events.groups();
    fields["node_changes"] = timeline.changes.size();
    fields["sub_edges"] = timeline.sub_edges.size();
    fields["tracks"] = sum_->states().tracks().size();
    fields["boundary_groups"] = sum_->states().groups().size();
    MINKREF_PUT(timeline, decided_by_doubles, decided_exactly);
    return fields;
  }

  std::vector<EdgeRow> edges() const {
    if (sum_->empty()) return {};
    return convolution_rows(sum_->states().timeline().events->edges());
  }

  /// left and right.
  using NumberRow = std::pair<int, int>;
  std::vector<NumberRow> winding_numbers(std::uint32_t edge) {
    std::vector<NumberRow> rows;
    if (sum_->empty() || sum_->followed() != ConvolutionType::full) return rows;
    if (edge >= events().edges().size()) {
      throw BadInput("unknown-edge", "there is no edge " + std::to_string(edge),
                     "give the place of one of edges()");
    }
    for (const SideNumbers& n : sum_->arrangement().winding_numbers(edge)) {
      rows.emplace_back(n.left, n.right);
    }
    return rows;
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
  std::optional<Rational> at_;  // where it was moved to
};

}  // namespace

void bind_dynamic(nb::module_& module) {
  nb::class_<Dynamic> bound(module, "DynamicSum",
                            "sP + Q over a closed window of scales, by dynamic update.");
  bind_of_window(bound)
      .def_ro("seconds", &Dynamic::seconds, "Of finding all events.")
      .def("counts", &Dynamic::counts)
      .def("edges", &Dynamic::edges, Released())
      .def("move_to", &Dynamic::move_to, "scale"_a,
           "Steps to a scale: insertions, deletions, swaps, updated nodes, groups of events.")
      .def("update", &Dynamic::update, "scale"_a, Released(),
           "Steps to a scale and places all nodes, in doubles; gives the seconds.")
      .def("sum", &Dynamic::sum, nb::keep_alive<0, 1>(), Released(),
           "The sum where it stands, exact.")
      .def("event_scales", &Dynamic::event_scales, Released(),
           "All scales of arrangement events: (scale, kinds), ascending.")
      .def("difference_from_scratch", &Dynamic::difference_from_scratch, Released(),
           "What differs from the static arrangement and sum at the same scale; empty: nothing.")
      .def("winding_numbers", &Dynamic::winding_numbers, "edge"_a, Released(),
           "Winding numbers (left, right) beside an edge where it stands, from its start to its "
           "first node and after each node; none on the route dynamic.")
      .def("state_counts", &Dynamic::state_counts, Released(),
           "States of the boundary: where each begins, (holes, components, vertices, holes and "
           "components at the scale itself).");
  bind_history(bound);
}

}  // namespace minkref::python
