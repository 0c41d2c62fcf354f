#include "reference/plane/critical/pair_event_search.hpp"

#include <optional>

#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/critical/event_search.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {
namespace {

/// Pair events as a search asks for them (event_search.hpp).
class SearchedPairs {
 public:
  SearchedPairs(const PairEvents& events, const PolygonSet& P, const PolygonSet& Q)
      : events_(events),
        moving_(moving_edges<Vector2<Rational>>(events.edges, scalar_operand<Rational>(P, {}),
                                                scalar_operand<Rational>(Q, {}))) {}

  std::string_view what() const { return "pair events"; }
  const std::vector<ConvolutionEdge>& edges() const { return events_.edges; }
  Rational scale(std::size_t i) const {
    const PairEvent& e = events_.events[i];
    return event_scale(PlainKernel<Rational>(), moving_[e.a], moving_[e.b], e);
  }
  std::uint32_t rank(std::size_t i) const { return events_.events[i].rank; }
  Enclosure about(std::size_t i, int coordinate) const {
    if (!bounds_) bounds_.emplace(moving_);
    return place_bounds(events_.events[i], *bounds_, coordinate);
  }
  Point at(std::size_t i) const { return event_places(events_, i, i + 1, moving_).front().at; }
  std::string_view kind(std::size_t i) const {
    return events_.events[i].parallel ? "parallel" : "pair";
  }
  std::string_view change(std::size_t i) const { return name(events_.events[i].change); }
  bool has_edge(std::size_t i, const std::vector<bool>& wanted) const {
    return wanted[events_.events[i].a] || wanted[events_.events[i].b];
  }

 private:
  const PairEvents& events_;
  const std::vector<RationalEdge> moving_;
  mutable std::optional<EdgeBounds> bounds_;
};

}  // namespace

void keep_events(PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                 const EventCondition& condition) {
  keep_those(events.events, SearchedPairs(events, P, Q), condition);
}

Enclosure place_bounds(const PairEvent& event, const EdgeBounds& bounds, int coordinate) {
  const double scale = event.approximate;
  if (event.parallel) {
    return intersection(bounds.of_edge(event.a, coordinate, scale),
                        bounds.of_edge(event.b, coordinate, scale));
  }
  // One end lies on the other edge: the edges meet there.
  const auto end = static_cast<PairEnd>(event.half_line);
  const bool of_a = end == PairEnd::a0 || end == PairEnd::a1;
  const bool second = end == PairEnd::a1 || end == PairEnd::b1;
  return bounds.of_end(of_a ? event.a : event.b, second, coordinate, scale);
}

}  // namespace minkref::inline plane
