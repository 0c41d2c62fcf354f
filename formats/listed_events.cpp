#include "formats/listed_events.hpp"

#include <algorithm>

#include "formats/write_events.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/event_search.hpp"
#include "reference/plane/critical/pair_event_search.hpp"
#include "reference/plane/dynamic/node_track.hpp"

namespace minkref {
namespace {

const PairEvent& pair_of(const ArrangementEvents& events, const ListedEvent& event) {
  return events.pairs().events[event.index];
}

/// The questions of a search about arrangement events (event_search.hpp).
class SearchedArrangement {
 public:
  SearchedArrangement(const std::vector<RankedEvent>& list, const ArrangementEvents& events)
      : list_(list), events_(events) {}

  std::string_view what() const { return "arrangement events"; }
  const std::vector<ConvolutionEdge>& edges() const { return events_.edges(); }
  Rational scale(std::size_t i) const { return events_.exact(list_[i].event.group); }
  std::uint32_t rank(std::size_t i) const { return list_[i].rank; }
  /// The place of an event lies on each of its edges.
  Enclosure about(std::size_t i, int coordinate) const {
    if (!bounds_) bounds_.emplace(events_.moving());
    const ListedEvent& event = list_[i].event;
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
  Point at(std::size_t i) const { return listed_row(events_, list_[i].event).at; }
  std::string_view kind(std::size_t i) const { return kind_name(events_, list_[i].event); }
  std::string_view change(std::size_t i) const { return change_name(events_, list_[i].event); }
  bool has_edge(std::size_t i, const std::vector<bool>& wanted) const {
    const auto edges = edges_of(events_, list_[i].event);
    return std::any_of(edges.begin(), edges.end(), [&](auto e) { return wanted[e]; });
  }

 private:
  const std::vector<RankedEvent>& list_;
  const ArrangementEvents& events_;
  mutable std::optional<EdgeBounds> bounds_;
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
  keep_those(list, SearchedArrangement(list, events), condition);
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
