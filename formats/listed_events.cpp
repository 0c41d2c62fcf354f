#include "formats/listed_events.hpp"

#include <algorithm>

#include "formats/write_events.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/pair_event_search.hpp"
#include "reference/plane/dynamic/node_track.hpp"

namespace minkref {
namespace {

const PairEvent& pair_of(const ArrangementEvents& events, const ListedEvent& event) {
  return events.pairs().events[event.index];
}

class Search {
 public:
  Search(std::vector<RankedEvent>& list, const ArrangementEvents& events)
      : list_(list), events_(events) {}

  void keep(const EventCondition& condition) {
    const EventTest test =
        event_test(condition, [this](const EventCondition& field) { return of_field(field); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      look_for_interrupt();
      if (test(i)) list_[kept++] = list_[i];  // an event is looked at before it is overwritten
    }
    list_.resize(kept);
    list_.shrink_to_fit();
  }

 private:
  using Test = EventCondition::Test;

  EventTest of_field(const EventCondition& c) {
    const auto& list = list_;
    const ArrangementEvents& events = events_;
    if (c.test == Test::in_range && (c.field == "s" || c.field == "rank")) {
      const bool scales = c.field == "s";
      const auto [first, last] = places_in_range(list.size(), c.range, [&](std::size_t i) {
        return scales ? events.exact(list[i].event.group) : Rational(list[i].rank);
      });
      return [first = first, last = last](std::size_t i) { return i >= first && i < last; };
    }
    if (c.test == Test::in_range && (c.field == "x" || c.field == "y")) {
      if (!bounds_) bounds_.emplace(events_.moving());
      return [this, range = c.range, quick = EnclosedNumbers(c.range),
              coordinate = c.field == "y" ? 1 : 0](std::size_t i) {
        const Enclosure about = bounds_of(list_[i].event, coordinate);
        if (const auto known = quick.in_range(about.lower, about.upper)) return *known;
        const Point at = listed_row(events_, list_[i].event).at;
        return range.holds(coordinate == 0 ? at.x : at.y);
      };
    }
    if (c.test == Test::one_of && (c.field == "kind" || c.field == "change")) {
      const auto name = c.field == "kind" ? kind_name : change_name;
      return [&, name, c](std::size_t i) { return c.has_word(name(events, list[i].event)); };
    }
    if (c.test == Test::has_edge) {
      return [&, wanted = matching_edges(events.edges(), c.edge)](std::size_t i) {
        const auto edges = edges_of(events, list[i].event);
        return std::any_of(edges.begin(), edges.end(), [&](auto e) { return wanted[e]; });
      };
    }
    throw BadInput("unknown-field", "arrangement events have no \"" + c.field + "\"",
                   "ask for another");
  }

  /// The place of an event is on each of its edges.
  Enclosure bounds_of(const ListedEvent& event, int coordinate) const {
    if (event.kind == ListedEvent::Kind::pair) {
      return place_bounds(pair_of(events_, event), *bounds_, coordinate);
    }
    const double scale = events_.approximate(event.group);
    const auto edges = edges_of(events_, event);
    Enclosure result = bounds_->of_edge(edges.front(), coordinate, scale);
    for (const std::uint32_t edge : edges) {
      result = intersection(result, bounds_->of_edge(edge, coordinate, scale));
    }
    return result;
  }

  std::vector<RankedEvent>& list_;
  const ArrangementEvents& events_;
  std::optional<EdgeBounds> bounds_;
};

}  // namespace

std::string_view kind_name(const ArrangementEvents& events, const ListedEvent& event) {
  if (event.kind == ListedEvent::Kind::triple) return "triple";
  if (event.kind == ListedEvent::Kind::passing) return "parallel";
  return pair_of(events, event).parallel ? "parallel" : "pair";
}

std::string_view change_name(const ArrangementEvents& events, const ListedEvent& event) {
  return event.kind == ListedEvent::Kind::pair ? name(pair_of(events, event).change) : "swap";
}

std::vector<std::uint32_t> edges_of(const ArrangementEvents& events, const ListedEvent& event) {
  if (event.kind == ListedEvent::Kind::pair) {
    const PairEvent& pair = pair_of(events, event);
    return {pair.a, pair.b};
  }
  if (event.kind == ListedEvent::Kind::triple) {
    const TripleEvent& triple = events.triples()[event.index];
    return {triple.a, triple.b, triple.c};
  }
  const std::uint32_t other = events.table().nodes[event.index].other;
  return {std::min(event.edge, other), std::max(event.edge, other)};
}

EventRow listed_row(const ArrangementEvents& events, const ListedEvent& event) {
  EventRow row;
  row.kind = kind_name(events, event);
  row.change = change_name(events, event);
  row.edges = edges_of(events, event);
  if (event.kind == ListedEvent::Kind::pair) {
    auto place =
        event_places(events.pairs(), event.index, event.index + 1, events.moving()).front();
    row.scale = std::move(place.scale);
    row.at = std::move(place.at);
    row.to = std::move(place.to);
    return row;
  }
  row.scale = events.exact(event.group);
  const bool triple = event.kind == ListedEvent::Kind::triple;
  const std::uint32_t edge = triple ? events.triples()[event.index].edge : event.edge;
  const std::uint32_t node = triple ? events.triples()[event.index].first : event.index;
  row.at = node_track(events, edge, node).at(row.scale);
  return row;
}

void keep_events(std::vector<RankedEvent>& list, const ArrangementEvents& events,
                 const EventCondition& condition) {
  Search(list, events).keep(condition);
}

std::size_t distinct_scales(const std::vector<RankedEvent>& list) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    count += i == 0 || list[i].rank != list[i - 1].rank;
  }
  return count;
}

std::string events_as_json(const std::vector<RankedEvent>& list, const ArrangementEvents& events,
                           const std::vector<std::string>& edges, std::size_t first,
                           std::size_t last, std::string_view end) {
  std::string text;
  for (std::size_t i = first; i < std::min(last, list.size()); ++i) {
    look_for_interrupt();
    EventRow row = listed_row(events, list[i].event);
    row.rank = list[i].rank;
    append_json(text, row, edges, end);
  }
  return text;
}

}  // namespace minkref
