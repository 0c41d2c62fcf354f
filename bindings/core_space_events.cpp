// Binds the critical scales for sums of polyhedra.
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
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
#include "bindings/vector_caster.hpp"
#include "reference/paper/trials/facet_contact_trial.hpp"
#include "reference/space/critical/critical_events.hpp"
#include "reference/space/critical/crossing_facets.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Numbers = std::vector<std::uint32_t>;
/// Scale, kind, change; each facet's number, with the corner or side that touches; the place.
using EventRow =
    std::tuple<std::string, std::string, std::string, std::uint32_t, std::optional<unsigned>,
               std::uint32_t, std::optional<unsigned>, std::optional<ExactSpacePoint>>;

const char* name(ContactKind kind) {
  switch (kind) {
    case ContactKind::vertex:
      return "vertex";
    case ContactKind::edge:
      return "edge";
    case ContactKind::parallel:
      return "parallel";
  }
  return "";
}

const char* name(ContactChange change) {
  switch (change) {
    case ContactChange::birth:
      return "birth";
    case ContactChange::death:
      return "death";
    case ContactChange::touch:
      return "touch";
    case ContactChange::pass:
      return "pass";
  }
  return "";
}

const char* name(FacetKind kind) {
  switch (kind) {
    case FacetKind::fv:
      return "fv";
    case FacetKind::vf:
      return "vf";
    case FacetKind::ee:
      return "ee";
  }
  return "";
}

/// Scale, kind, change; three or four facets; for each the side that singles the point out, if any;
/// the place.
using ConcurrentRow = std::tuple<std::string, std::string, std::string, Numbers,
                                 std::vector<std::optional<unsigned>>, ExactSpacePoint>;

ConcurrentRow row(const CriticalEvents& events, const ConcurrentEvent& e) {
  Numbers facets(e.facets.begin(), e.facets.begin() + (e.is_of_four() ? 4 : 3));
  std::vector<std::optional<unsigned>> sides(facets.size());
  for (std::size_t k = 0; k < e.sides.size(); ++k) {
    if (e.sides[k] != ConcurrentEvent::no_side) sides[k] = e.sides[k];
  }
  return {to_string(e.s.exact()),
          e.is_of_four() ? "four" : "triple",
          name(e.change),
          facets,
          sides,
          to_strings(place_of(events, e))};
}

EventRow row(const CriticalEvents& events, const SpacePairEvent& e) {
  const auto corner = [](std::uint8_t number) -> std::optional<unsigned> {
    if (number == FacetEvent::no_corner) return std::nullopt;
    return number;
  };
  const auto place = place_of(events, e);
  return {to_string(e.event.s.exact()), name(e.event.kind),
          name(e.event.change),         e.first,
          corner(e.event.of_first),     e.second,
          corner(e.event.of_second),    place ? std::optional(to_strings(*place)) : std::nullopt};
}

template <class Row, class Event>
std::vector<Row> rows_of(const CriticalEvents& events, const std::vector<Event>& list,
                         std::size_t first, std::size_t count) {
  std::vector<Row> result;
  const std::size_t start = std::min(first, list.size()),
                    end = start + std::min(count, list.size() - start);
  for (std::size_t k = start; k < end; ++k) result.push_back(row(events, list[k]));
  return result;
}

std::vector<EventRow> rows(const CriticalEvents& events, std::size_t first, std::size_t count) {
  return rows_of<EventRow>(events, events.events, first, count);
}

std::vector<ConcurrentRow> concurrent(const CriticalEvents& events, std::size_t first,
                                      std::size_t count) {
  return rows_of<ConcurrentRow>(events, events.concurrent, first, count);
}

std::map<std::string, std::uint64_t> trial(const Surface& P, const Surface& Q,
                                           const std::string& arithmetic, const Words& readings) {
  const FacetContactTrial found =
      facet_contact_trial(P.value(), Q.value(), arithmetic, readings_of<FacetReadings>(readings));
  return {{"pairs", found.pairs},
          {"parallel_pairs", found.parallel_pairs},
          {"coplanar_pairs", found.coplanar_pairs},
          {"undecided_pairs", found.undecided_pairs},
          {"roots", found.roots},
          {"false_inconsistent", found.false_inconsistent},
          {"false_identity", found.false_identity},
          {"invented_roots", found.invented_roots},
          {"events", found.events},
          {"missed", found.missed},
          {"parallel_faces", found.parallel_faces},
          {"parallel_sides", found.parallel_sides},
          {"side_along_plane", found.side_along_plane},
          {"invented", found.invented},
          {"misplaced", found.misplaced}};
}

double seconds_since(std::chrono::steady_clock::time_point began) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

EventsOf what(bool concurrent) { return concurrent ? EventsOf::all : EventsOf::pairs; }

/// Kind, and each corner's vertices from P and from Q.
std::tuple<std::string, Numbers, Numbers> facet(const CriticalEvents& events, std::size_t number) {
  const MovingFacet& found = events.convolution->facets.at(number);
  Numbers of_P, of_Q;
  for (std::size_t k = 0; k < found.size; ++k) {
    of_P.push_back(found.names[k].of_P);
    of_Q.push_back(found.names[k].of_Q);
  }
  return {name(found.kind), of_P, of_Q};
}

void bind_facet_contacts(nb::module_& module) {
  module.def("facet_contact_trial", &trial, "P"_a, "Q"_a, "arithmetic"_a, "readings"_a = Words{},
             Released(),
             "The paper's way to the events of two facets (Sec. 5.1, 5.2) in an arithmetic, on all "
             "pairs of facets, against the exact events. `readings`: as `facet_readings` lists "
             "them; those left out are the printed ones. Raises BadInput, LimitExceeded.");
  bind_reading_check<FacetReadings>(module, "check_facet_reading");
  module.def(
      "facet_readings", [] { return python::rows_of(facet_reading_names()); },
      "The choices of the way to events of facets: name, values (the printed one first), the "
      "corrected one, section of the paper.");
}

}  // namespace

void bind_space_events(nb::module_& module) {
  nb::class_<CriticalEvents>(module, "SpaceEvents",
                             "Events of pairs of facets of the convolution in space, sorted.")
      .def("__len__", [](const CriticalEvents& events) { return events.events.size(); })
      .def(
          "rows", &rows, "first"_a, "count"_a, Released(),
          "Events from the number `first` on: scale, kind, change; the number of one facet and its "
          "corner or side that touches, if there is one, and the same of the other; the place.")
      .def("concurrent", &concurrent, "first"_a, "count"_a, Released(),
           "Events of three and of four facets from the number `first` on: scale, kind (triple or "
           "four), change; the numbers of the facets; of three, which of them has the point on a "
           "side, and the number of that side; the place.")
      .def("facet", &facet, "number"_a,
           "Of a facet: its kind, and the vertices of P and of Q whose sums its corners are.")
      .def(
          "counts",
          [](const CriticalEvents& events) {
            std::map<std::string, std::uint64_t> counts{
                {"facets", events.convolution ? events.convolution->facets.size() : 0},
                {"near_pairs", events.near_pairs},
                {"pairs_with_events", events.meeting_pairs},
                {"distinct", distinct_scales(events.events, events.concurrent)},
                {"distinct_of_pairs", distinct_scales(events.events, {})},
                {"distinct_of_more", distinct_scales({}, events.concurrent)},
                {"by_float", events.signs.by_float},
                {"by_integer", events.signs.by_integer}};
            for (const ContactKind kind :
                 {ContactKind::vertex, ContactKind::edge, ContactKind::parallel}) {
              counts[name(kind)] = 0;
            }
            for (const SpacePairEvent& e : events.events) ++counts[name(e.event.kind)];
            counts["tracks"] = events.tracks;
            counts["four"] = static_cast<std::uint64_t>(
                std::count_if(events.concurrent.begin(), events.concurrent.end(),
                              [](const ConcurrentEvent& e) { return e.is_of_four(); }));
            counts["triple"] = events.concurrent.size() - counts["four"];
            return counts;
          },
          Released(), "How many there are of what.");
  nb::class_<CrossingFacets>(
      module, "CrossingFacets",
      "Which facets of the convolution meet, from scale to scale by the events in between.")
      .def(
          "__init__",
          [](CrossingFacets* self, std::shared_ptr<CriticalEvents> events,
             const std::string& start) {
            new (self) CrossingFacets(std::move(events), parse_rational(start));
          },
          "events"_a, "start"_a, Released())
      .def(
          "move_to",
          [](CrossingFacets& self, const std::string& s) {
            const Rational scale = parse_rational(s);
            const auto began = std::chrono::steady_clock::now();
            const std::uint64_t events = self.move_to(scale);
            return std::tuple(events, seconds_since(began));
          },
          "scale"_a, Released(), "How many events there were on the way, and seconds.")
      .def("pairs", &CrossingFacets::pairs, Released(), "Of facets that meet, ascending.");
  module.def(
      "meeting_facets",
      [](const std::shared_ptr<CriticalEvents>& events, const std::string& s) {
        const Rational scale = parse_rational(s);
        const auto began = std::chrono::steady_clock::now();
        auto found = meeting_pairs_at(*events->convolution, scale);
        return std::tuple(std::move(found), seconds_since(began));
      },
      "events"_a, "scale"_a, Released(),
      "Pairs of facets that meet at a scale, from scratch, and seconds. Exact.");
  module.def(
      "space_events",
      [](const Surface& P, const Surface& Q, const std::string& from, const std::string& to,
         unsigned threads, const std::optional<Progress>& progress, bool concurrent,
         std::optional<std::uint64_t> most_events) {
        return critical_events_in_space(P.value(), Q.value(), parse_rational(from),
                                        parse_rational(to), build_on(threads, progress),
                                        what(concurrent),
                                        most_events ? MostEvents{*most_events} : MostEvents{});
      },
      "P"_a, "Q"_a, "from_scale"_a, "to_scale"_a, "threads"_a = 1, "progress"_a = nb::none(),
      "concurrent"_a = false, "most_events"_a = nb::none(), Released(),
      "All scales of the closed window at which two facets of the convolution of sP and Q start, "
      "change or stop to meet (Sec. 5), of valid polyhedra that do not cross themselves; if "
      "`concurrent`, also those of three and of four. Exact. Raises BadInput, LimitExceeded, also "
      "where a thread finds more than `most_events`.");
  module.def(
      "space_events_of_all_pairs",
      [](const Surface& P, const Surface& Q, const std::string& from, const std::string& to,
         bool concurrent) {
        return critical_events_of_all_pairs(P.value(), Q.value(), parse_rational(from),
                                            parse_rational(to), what(concurrent));
      },
      "P"_a, "Q"_a, "from_scale"_a, "to_scale"_a, "concurrent"_a = false, Released(),
      "The same by all pairs of facets, without boxes and filters: slow.");
  bind_facet_contacts(module);
}

}  // namespace minkref::python
