// Arrangement events in Python.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/listed_events.hpp"
#include "reference/error.hpp"
#include "reference/plane/critical/event_search.hpp"
#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/dynamic/event_list.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// All arrangement events of a closed window.
class Arrangement {
 public:
  Arrangement(const Set& P, const Set& Q, const std::optional<std::string>& from,
              const std::optional<std::string>& to, const std::string& route)
      : P_(followed_operand(P.value, convolution_followed(route))),
        Q_(followed_operand(Q.value, convolution_followed(route))) {
    const Stopwatch watch;
    const ConvolutionType of = convolution_followed(route);
    const ScaleWindow window = window_of(from, to);
    refuse_bad_operands(P_, Q_, 1);
    refuse_large_convolution(P_, Q_, of == ConvolutionType::full);
    refuse_bad_window(window);
    if (!P_.empty() && !Q_.empty()) {
      events_ = std::make_unique<ArrangementEvents>(P_, Q_, opened(window), of);
      list_ = listed_events(*events_, window);
    }
    seconds = watch.seconds();
  }

  /// scale, kind, change, edges, at, to.
  using Row = std::tuple<std::string, std::string, std::string, std::vector<std::uint32_t>,
                         ExactPoint, std::optional<ExactPoint>>;

  std::vector<Row> rows(const std::vector<std::uint32_t>& which) const {
    std::vector<Row> result;
    for (const std::uint32_t i : which) {
      look_for_interrupt();
      const EventRow event = listed_row(*events_, list_.at(i));
      result.emplace_back(to_string(event.scale), std::string(event.kind),
                          std::string(event.change), event.edges, to_strings(event.at),
                          event.to ? std::optional(to_strings(*event.to)) : std::nullopt);
    }
    return result;
  }

  /// List positions of the events of a kind: pair, parallel, triple or arrangement (all).
  std::vector<std::uint32_t> of_kind(const std::string& kind) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < list_.size(); ++i) {
      if (kind == "arrangement" || kind == kind_name(*events_, list_[i])) result.push_back(i);
    }
    return result;
  }

  std::vector<EdgeRow> edges() const {
    return events_ ? convolution_rows(events_->edges()) : std::vector<EdgeRow>{};
  }

  /// For each given event, the count of different lower scales among the given events.
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
    MINKREF_PUT(pairs, pairs, filtered_pairs);
    MINKREF_PUT(pairs.statistics, s_edges, t_edges, kernel);
    std::uint64_t swaps = 0;
    for (const ListedEvent& event : list_) {
      if (event.kind != ListedEvent::Kind::triple) continue;
      const unsigned bits = events_->triples()[event.index].swaps;
      swaps += (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1);
    }
    fields["node_swaps"] = swaps;
    return fields;
  }

  /// Null if an operand is empty.
  const ArrangementEvents* events() const { return events_.get(); }
  const std::vector<ListedEvent>& list() const { return list_; }

  double seconds = 0;

 private:
  PolygonSet P_, Q_;
  std::unique_ptr<ArrangementEvents> events_;
  std::vector<ListedEvent> list_;
};

/// The events of a kind, or a part of the list.
class ArrangementList {
 public:
  ArrangementList(const Arrangement& all, const std::string& kind) : all_(all) {
    const auto which = all.of_kind(kind);
    const auto ranks = all.ranks(which);
    list_.reserve(which.size());
    for (std::size_t i = 0; i < which.size(); ++i) {
      list_.push_back({all.list()[which[i]], ranks[i]});
    }
  }

  std::size_t size() const { return list_.size(); }
  std::size_t distinct() const { return distinct_scales(list_); }

  void keep(const EventCondition& condition) {
    if (all_.events()) keep_events(list_, *all_.events(), condition);
  }

  using Row = std::tuple<std::string, std::uint32_t, std::string, std::string,
                         std::vector<std::uint32_t>, ExactPoint, std::optional<ExactPoint>>;
  std::vector<Row> rows(std::size_t first, std::size_t last) const {
    std::vector<Row> result;
    for (std::size_t i = first; i < std::min(last, list_.size()); ++i) {
      look_for_interrupt();
      const EventRow event = listed_row(*all_.events(), list_[i].event);
      result.emplace_back(to_string(event.scale), list_[i].rank, std::string(event.kind),
                          std::string(event.change), event.edges, to_strings(event.at),
                          event.to ? std::optional(to_strings(*event.to)) : std::nullopt);
    }
    return result;
  }

  nb::bytes json(std::size_t first, std::size_t last, const std::vector<std::string>& edges,
                 const std::string& end) const {
    std::string text;
    if (all_.events()) {
      if (edges.size() != all_.events()->edges().size()) {
        throw BadInput("wrong-length", "there is not one text for each edge",
                       "give those of edges()");
      }
      const Computing released;
      text = events_as_json(list_, *all_.events(), edges, first, last, end);
    }
    return nb::bytes(text.data(), text.size());
  }

 private:
  const Arrangement& all_;
  std::vector<RankedEvent> list_;
};

}  // namespace

void bind_arrangement(nb::module_& module) {
  nb::class_<Arrangement> bound(
      module, "ArrangementEvents",
      "Pair, parallel and triple events of sP + Q in a closed window, sorted.");
  bind_of_window(bound)
      .def_ro("seconds", &Arrangement::seconds)
      .def("counts", &Arrangement::counts)
      .def("edges", &Arrangement::edges, Released(), "Rows as reduced_convolution's.")
      .def("of_kind", &Arrangement::of_kind, "kind"_a, Released(),
           "The places of pair, parallel, triple or all (arrangement) events in the list.")
      .def("ranks", &Arrangement::ranks, "which"_a, Released(),
           "Events of equal scale have equal rank; ranks count from 0.")
      .def("rows", &Arrangement::rows, "which"_a, Released(),
           "(scale, kind, change, edges, at, to) of these events, exact.");
  nb::class_<ArrangementList>(module, "ArrangementList",
                              "Pair, parallel, triple or all (arrangement) events, sorted.")
      .def(nb::init<const Arrangement&, const std::string&>(), "events"_a, "kind"_a,
           nb::keep_alive<1, 2>(), Released())
      .def("__len__", &ArrangementList::size)
      .def("distinct", &ArrangementList::distinct, Released(),
           "How many different scales the events have that are there.")
      .def("keep", &ArrangementList::keep, "condition"_a, Released(),
           "Takes out all events that do not meet the condition; ranks stay those among all.")
      .def("rows", &ArrangementList::rows, "first"_a, "last"_a, Released(),
           "(scale, rank, kind, change, edges, at, to) of the events first to last - 1, exact.")
      .def("json", &ArrangementList::json, "first"_a, "last"_a, "edges"_a, "end"_a,
           "Events first to last - 1 as JSON objects in UTF-8, each followed by `end`; `edges`: "
           "the text of each edge.");
}

}  // namespace minkref::python
