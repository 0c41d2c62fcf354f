// Critical scales in Python.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>

#include "bindings/core.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/core_timeline.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/write_events.hpp"
#include "reference/error.hpp"
#include "reference/paper/trials/precision_trial.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/event_search.hpp"
#include "reference/plane/critical/line_intersection.hpp"
#include "reference/plane/critical/pair_event_search.hpp"
#include "reference/plane/critical/pair_interval.hpp"
#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {

Form form_named(const std::string& name) {
  if (name == "corrected") return Form::corrected;
  if (name == "printed") return Form::printed;
  throw BadInput("unknown-form", "there is no form called \"" + name + "\"",
                 "use corrected or printed");
}

namespace {

/// Pair events with their operands, as followed.
struct Events {
  PairEvents value;
  PolygonSet P, Q;
  double seconds = 0;
};

EventKind kind_named(const std::string& name) {
  if (name == "pair") return EventKind::pair;
  if (name == "parallel") return EventKind::parallel;
  if (name == "both") return EventKind::both;
  throw BadInput("unknown-kind", "there is no kind of events called \"" + name + "\"",
                 "use pair, parallel or both");
}

Events find(const Set& P, const Set& Q, const std::optional<std::string>& from,
            const std::optional<std::string>& to, const std::string& kind, const std::string& form,
            const std::string& route) {
  ScaleWindow window;
  if (from) window.from = parse_rational(*from);
  if (to) window.to = parse_rational(*to);
  const Stopwatch watch;
  const ConvolutionType of = convolution_followed(route);
  refuse_large_convolution(P.value, Q.value, of == ConvolutionType::full);
  PolygonSet first = followed_operand(P.value, of), second = followed_operand(Q.value, of);
  PairEvents events =
      pair_events(first, second, window, kind_named(kind), form_named(form), false, of);
  const double taken = watch.seconds();
  return {std::move(events), std::move(first), std::move(second), taken};
}

std::vector<std::vector<ExactPoint>> cut_rings(const Set& set) {
  std::vector<std::vector<ExactPoint>> rings;
  const PolygonSet cut = cut_to_simply_connected(set.value);
  if (cut == set.value) return rings;
  for (const Polygon& polygon : cut.polygons) {
    auto& ring = rings.emplace_back();
    for (const Point& point : polygon.outer) ring.push_back(to_strings(point));
  }
  return rings;
}

/// scale, rank, change, parallel, a, b, at, to.
using Row = std::tuple<std::string, std::uint32_t, std::string, bool, std::uint32_t, std::uint32_t,
                       ExactPoint, std::optional<ExactPoint>>;

std::vector<Row> rows(const Events& events, std::size_t first, std::size_t last) {
  const auto places = event_places(events.value, first, last, events.P, events.Q);
  std::vector<Row> result;
  result.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PairEvent& event = events.value.events[first + i];
    const EventPlace& place = places[i];
    result.emplace_back(to_string(place.scale), event.rank, std::string(name(event.change)),
                        event.parallel, event.a, event.b, to_strings(place.at),
                        place.to ? std::optional(to_strings(*place.to)) : std::nullopt);
  }
  return result;
}

nb::bytes json(const Events& events, std::size_t first, std::size_t last,
               const std::vector<std::string>& edges, const std::string& end) {
  if (edges.size() != events.value.edges.size()) {
    throw BadInput("wrong-length", "there is not one text for each edge", "give those of edges()");
  }
  std::string text;
  {
    const Computing released;
    text = events_as_json(events.value, events.P, events.Q, edges, first, last, end);
  }
  return nb::bytes(text.data(), text.size());
}

using Columns = nb::typed<nb::dict, nb::str, nb::bytes>;

template <class T, class Get>
nb::bytes column(std::span<const PairEvent> events, Get&& get) {
  std::vector<T> values;
  values.reserve(events.size());
  for (const PairEvent& event : events) values.push_back(get(event));
  return nb::bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

Columns columns(const Events& events, std::size_t first, std::optional<std::size_t> end) {
  const auto& all = events.value.events;
  const std::size_t last = std::min(end.value_or(all.size()), all.size());
  const auto part = std::span(all).subspan(std::min(first, last), last - std::min(first, last));
  Columns result;
  result["rank"] = column<std::uint32_t>(part, [](const PairEvent& e) { return e.rank; });
  result["a"] = column<std::uint32_t>(part, [](const PairEvent& e) { return e.a; });
  result["b"] = column<std::uint32_t>(part, [](const PairEvent& e) { return e.b; });
  result["change"] = column<std::uint8_t>(
      part, [](const PairEvent& e) { return static_cast<std::uint8_t>(e.change); });
  result["parallel"] =
      column<std::uint8_t>(part, [](const PairEvent& e) { return std::uint8_t{e.parallel}; });
  return result;
}

/// The texts of the exact scales: each text's begin (and the end of all), the joined text, the
/// nearest doubles, and the text's index for each event.
std::tuple<nb::bytes, nb::bytes, nb::bytes, nb::bytes> texts_of_scales(
    const Events& events, std::size_t first, std::optional<std::size_t> last) {
  ScaleTexts found;
  {
    const Computing released;
    found = scale_texts(events.value, events.P, events.Q, first,
                        last.value_or(events.value.events.size()));
  }
  const auto bytes = [](const auto& values) {
    return nb::bytes(reinterpret_cast<const char*>(values.data()),
                     values.size() * sizeof(values.front()));
  };
  return {bytes(found.begins), bytes(found.text), bytes(found.nearest), bytes(found.which)};
}

void keep(Events& events, const EventCondition& condition) {
  keep_events(events.value, events.P, events.Q, condition);
}

Fields counts(const Events& events) {
  const PairEvents& value = events.value;
  Fields fields;
  fields["count"] = value.events.size();
  MINKREF_PUT(value, distinct, pairs, filtered_pairs, intersecting_pairs, always_meeting_pairs,
              touching_pairs, parallel_pairs);
  MINKREF_PUT(value.statistics, s_edges, t_edges, kernel, by_float, by_integer, by_rational);
  return fields;
}

Fields trial(const Set& P, const Set& Q, const std::string& arithmetic, const std::string& form) {
  PrecisionTrial result;
  {
    const Computing released;
    result = precision_trial(P.value, Q.value, arithmetic, form_named(form));
  }
  Fields fields;
  MINKREF_PUT(result, pairs, undecided_pairs, roots, false_inconsistent, false_identity,
              invented_roots, events, missed, invented, misplaced, inversions, merged);
  fields["all_right"] = result.all_right();
  return fields;
}

Fields forms(const Set& P, const Set& Q) {
  FormComparison result;
  {
    const Computing released;
    result = compare_forms(P.value, Q.value);
  }
  Fields fields;
  MINKREF_PUT(result, intersecting, touching, printed_right, printed_right_by_roots, printed_empty,
              printed_invented);
  return fields;
}

/// kind "S" or "T", then p, q and d of the edge: x and y each.
using EdgeNumbers = std::tuple<std::string, std::array<std::int64_t, 6>>;
/// "meeting" or, for parallel edges, "never", "once" or "always"; whether the interval is empty;
/// its bounds.
using IntervalRow =
    std::tuple<std::string, bool, std::optional<std::string>, std::optional<std::string>>;

MovingEdge<Vector2<Rational>> exact_edge(const EdgeNumbers& numbers) {
  const auto& kind = std::get<0>(numbers);
  const auto& n = std::get<1>(numbers);
  const auto vector = [&](std::size_t i) {
    return Vector2<Rational>(Rational(n[i]), Rational(n[i + 1]));
  };
  return {kind == "S" ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T, vector(0), vector(2),
          vector(4)};
}

using Bounds = std::optional<std::pair<std::optional<std::string>, std::optional<std::string>>>;

Bounds bounds(const BoundedScales<Rational>& interval) {
  if (interval.empty) return std::nullopt;
  const auto text = [](const std::optional<Rational>& bound) {
    return bound ? std::optional(to_string(*bound)) : std::nullopt;
  };
  return std::pair(text(interval.lower), text(interval.upper));
}

Fields pair_by_paper(const EdgeNumbers& first, const EdgeNumbers& second) {
  const auto a = exact_edge(first), b = exact_edge(second);
  const Rational turn = cross<Rational>(a.d, b.d);
  if (sign(turn) == 0) {
    throw BadInput("parallel-edges", "the lines of the two edges are parallel",
                   "ask pair_intervals");
  }
  const auto conditions = end_conditions<Rational>(a, b);
  const auto scales = end_scales<Rational>(conditions, Form::corrected);
  std::vector<std::optional<std::string>> ends;
  for (const auto& solution : scales) {
    ends.push_back(solution.kind == Solution::root ? std::optional(to_string(solution.scale))
                                                   : std::nullopt);
  }
  Fields fields;
  fields["ends"] = ends;
  fields["printed"] = bounds(printed_interval(scales));
  fields["convex"] = bounds(convex_interval(scales, sign(turn)));
  fields["corrected"] = bounds(corrected_interval(conditions));
  return fields;
}

std::string observation_1_in(const std::array<std::string, 2>& v,
                             const std::array<std::string, 2>& w,
                             const std::array<std::string, 2>& u, const std::string& form) {
  const auto vector = [](const std::array<std::string, 2>& texts) {
    return Vector2<Rational>(Rational(texts[0]), Rational(texts[1]));
  };
  return to_string(observation_1<Rational>(vector(v), vector(w), vector(u), form_named(form)));
}

std::vector<IntervalRow> pair_intervals(
    const std::vector<std::pair<EdgeNumbers, EdgeNumbers>>& pairs) {
  using K = GridKernel<Grid64>;
  const K kernel;
  const auto edge = [](const EdgeNumbers& numbers) {
    const auto& [kind, n] = numbers;
    for (const std::int64_t value : n) {
      if (value >= std::int64_t{1} << 58 || value <= -(std::int64_t{1} << 58)) {
        throw BadInput("too-large", "a coordinate has more than 58 bits", "give smaller ones");
      }
    }
    return MovingEdge<K::Vector>{kind == "S" ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T,
                                 {n[0], n[1]},
                                 {n[2], n[3]},
                                 {n[4], n[5]}};
  };
  const auto text = [](const std::optional<ScaleInterval<K>::Bound>& bound) {
    return bound ? std::optional(to_string(K::exact(bound->scale))) : std::nullopt;
  };
  const auto row = [&](std::string what, const ScaleInterval<K>& interval) -> IntervalRow {
    if (interval.empty) return {std::move(what), true, std::nullopt, std::nullopt};
    return {std::move(what), false, text(interval.lower), text(interval.upper)};
  };
  std::vector<IntervalRow> result;
  result.reserve(pairs.size());
  for (const auto& [first, second] : pairs) {
    const auto a = edge(first), b = edge(second);
    const auto conditions = pair_conditions(kernel, a, b);
    if (conditions.turn != 0) {
      result.push_back(
          row("meeting", intersection_of_half_lines<K>(kernel, conditions.half_lines)));
      continue;
    }
    using Lines = ParallelPair<K>::Lines;
    const ParallelPair<K> parallel = parallel_pair(kernel, a, b);
    if (parallel.lines == Lines::one_line_always) {
      result.push_back(row("always", parallel.interval));
    } else if (parallel.lines == Lines::one_line_at_one_scale &&
               parallel.meeting != Meeting::never) {
      const auto scale = to_string(K::exact(parallel.scale));
      result.emplace_back("once", false, scale, scale);
    } else {
      result.emplace_back("never", true, std::nullopt, std::nullopt);
    }
  }
  return result;
}

}  // namespace

void bind_events(nb::module_& module) {
  nb::class_<Events>(module, "PairEvents", "The pair and parallel events of sP + Q, sorted.")
      .def_ro("seconds", &Events::seconds)
      .def("__len__", [](const Events& events) { return events.value.events.size(); })
      .def("counts", counts, "Counts of pairs, events and signs.")
      .def(
          "edges", [](const Events& events) { return convolution_rows(events.value.edges); },
          Released(), "The edges that events name by their index: rows as reduced_convolution's.")
      .def("rows", rows, "first"_a, "last"_a, Released(),
           "Events first to last - 1: (scale, rank, change, parallel, a, b, at, to), exact.")
      .def(
          "json", json, "first"_a, "last"_a, "edges"_a, "end"_a,
          "Events first to last - 1 as JSON objects in UTF-8, each followed by `end`; `edges`: the "
          "text of each edge.")
      .def("columns", columns, "first"_a = 0, "last"_a = nb::none(),
           "Events first to last - 1 as little-endian columns: rank, a, b "
           "(32 bits), change (0 birth, 1 death, 2 touch, 3 overlap), parallel.")
      .def("scale_texts", texts_of_scales, "first"_a = 0, "last"_a = nb::none(),
           "The exact scales of events first to last - 1, each once: where each text begins (64 "
           "bits), all texts, the nearest doubles, and of each event which (32 bits).")
      .def("keep", keep, "condition"_a, Released(),
           "Takes out all events that do not meet the condition; ranks and counts() stay those of "
           "all.")
      .def(
          "distinct", [](const Events& events) { return distinct_scales(events.value.events); },
          Released(), "How many different scales the events have that are there.");
  module.def("pair_events", find, "P"_a, "Q"_a, "from_scale"_a = nb::none(),
             "to_scale"_a = nb::none(), "kind"_a = "both", "form"_a = "corrected",
             "route"_a = "dynamic", Released(),
             "All scales at which two edges of the reduced convolution, or on the route winding of "
             "the full one, start or stop meeting.");
  module.def("cut_rings", cut_rings, "P"_a, Released(),
             "The rings of a set with holes, cut along slits; none for a set without holes. Edges "
             "on the route winding are numbered along them.");
  module.def("pair_intervals", pair_intervals, "pairs"_a, Released(),
             "When two edges meet: for pairs of (kind, (px, py, qx, qy, dx, dy)), an edge from "
             "s p + q along d, rows (case, empty, lower, upper).");
  module.def(
      "pair_by_paper", pair_by_paper, "a"_a, "b"_a,
      "Two edges as for pair_intervals, not parallel, by the paper's way: the scale at which "
      "the lines cross in each end (a0, a1, b0, b1), and the interval in which they meet, "
      "printed, by the rule for convex P, and corrected: (lower, upper), or None.");
  module.def("observation_1", observation_1_in, "v"_a, "w"_a, "u"_a, "form"_a,
             "The parameter of Observation 1, printed or corrected.");
  module.def("precision_trial", trial, "P"_a, "Q"_a, "arithmetic"_a, "form"_a,
             "The paper's way to the pair events in an arithmetic, against the exact ones.");
  module.def("compare_forms", forms, "P"_a, "Q"_a,
             "The printed interval of every pair against the corrected one.");
}

}  // namespace minkref::python
