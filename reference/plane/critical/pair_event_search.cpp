#include "reference/plane/critical/pair_event_search.hpp"

#include <algorithm>
#include <array>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_places.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref {
namespace {

constexpr std::array<const char*, 4> change_names{"birth", "death", "touch", "overlap"};

class Search {
 public:
  Search(PairEvents& events, const PolygonSet& P, const PolygonSet& Q)
      : events_(events),
        edges_(moving_edges<Vector2<Rational>>(events.edges, scalar_operand<Rational>(P, {}),
                                               scalar_operand<Rational>(Q, {}))) {}

  void keep(const EventCondition& condition) {
    const EventTest test =
        event_test(condition, [this](const EventCondition& field) { return of_field(field); });
    auto& all = events_.events;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      look_for_interrupt();
      if (test(i)) all[kept++] = all[i];  // an event is looked at before it is overwritten
    }
    all.resize(kept);
    all.shrink_to_fit();
  }

 private:
  using Test = EventCondition::Test;

  EventTest of_field(const EventCondition& c) {
    const auto& all = events_.events;
    if (c.test == Test::in_range && (c.field == "s" || c.field == "rank")) {
      const bool scales = c.field == "s";
      const PlainKernel<Rational> kernel;
      const auto [first, last] = places_in_range(all.size(), c.range, [&](std::size_t i) {
        const PairEvent& e = all[i];
        return scales ? event_scale(kernel, edges_[e.a], edges_[e.b], e) : Rational(e.rank);
      });
      return [first = first, last = last](std::size_t i) { return i >= first && i < last; };
    }
    if (c.test == Test::in_range && (c.field == "x" || c.field == "y")) {
      if (!bounds_) bounds_.emplace(edges_);
      return [this, range = c.range, quick = EnclosedNumbers(c.range),
              coordinate = c.field == "y" ? 1 : 0](std::size_t i) {
        const Enclosure about = place_bounds(events_.events[i], *bounds_, coordinate);
        if (const auto known = quick.in_range(about.lower, about.upper)) return *known;
        const Point at = event_places(events_, i, i + 1, edges_).front().at;
        return range.holds(coordinate == 0 ? at.x : at.y);
      };
    }
    if (c.test == Test::one_of && c.field == "kind") {
      return [&all, pair = c.has_word("pair"), parallel = c.has_word("parallel")](std::size_t i) {
        return all[i].parallel ? parallel : pair;
      };
    }
    if (c.test == Test::one_of && c.field == "change") {
      std::array<bool, 4> wanted{};
      for (std::size_t k = 0; k < wanted.size(); ++k) wanted[k] = c.has_word(change_names[k]);
      return
          [&all, wanted](std::size_t i) { return wanted[static_cast<std::size_t>(all[i].change)]; };
    }
    if (c.test == Test::has_edge) {
      return [&all, wanted = matching_edges(events_.edges, c.edge)](std::size_t i) {
        return wanted[all[i].a] || wanted[all[i].b];
      };
    }
    throw BadInput("unknown-field", "pair events have no \"" + c.field + "\"", "ask for another");
  }

  PairEvents& events_;
  const std::vector<RationalEdge> edges_;
  std::optional<EdgeBounds> bounds_;
};

}  // namespace

void keep_events(PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                 const EventCondition& condition) {
  Search(events, P, Q).keep(condition);
}

Enclosure place_bounds(const PairEvent& event, const EdgeBounds& bounds, int coordinate) {
  const double scale = event.approximate;
  if (event.parallel) {
    return intersection(bounds.of_edge(event.a, coordinate, scale),
                        bounds.of_edge(event.b, coordinate, scale));
  }
  // One end lies on the other edge: that is where they meet.
  const auto end = static_cast<PairEnd>(event.half_line);
  const bool of_a = end == PairEnd::a0 || end == PairEnd::a1;
  const bool second = end == PairEnd::a1 || end == PairEnd::b1;
  return bounds.of_end(of_a ? event.a : event.b, second, coordinate, scale);
}

std::size_t distinct_scales(const PairEvents& events) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < events.events.size(); ++i) {
    count += i == 0 || events.events[i].rank != events.events[i - 1].rank;
  }
  return count;
}

}  // namespace minkref
