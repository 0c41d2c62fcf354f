#include "reference/plane/critical/event_places.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/critical/line_intersection.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {
namespace {

using Vector = Vector2<Rational>;
using Edge = MovingEdge<Vector>;

Point point(const Vector& v) { return {v.x(), v.y()}; }

/// The common part of two edges on one line, from the positions of their ends along it.
EventPlace common_part(const Edge& a, const Edge& b, const Rational& scale) {
  struct End {
    Rational along;
    Vector at;
  };
  const auto ends = [&](const Edge& edge) {
    const Vector first = at(start_of(edge), scale), second = at(end_of(edge), scale);
    std::pair<End, End> result{{a.d.dot(first), first}, {a.d.dot(second), second}};
    if (result.second.along < result.first.along) std::swap(result.first, result.second);
    return result;
  };
  const auto x = ends(a), y = ends(b);
  const End& from = x.first.along < y.first.along ? y.first : x.first;
  const End& to = x.second.along < y.second.along ? x.second : y.second;
  EventPlace place{scale, point(from.at), {}};
  if (from.along < to.along) place.to = point(to.at);
  return place;
}

}  // namespace

std::vector<EventPlace> event_places(const PairEvents& events, std::size_t first, std::size_t last,
                                     const PolygonSet& P, const PolygonSet& Q) {
  return event_places(events, first, last,
                      moving_edges<Vector>(events.edges, scalar_operand<Rational>(P, {}),
                                           scalar_operand<Rational>(Q, {})));
}

std::vector<EventPlace> event_places(const PairEvents& events, std::size_t first, std::size_t last,
                                     const std::vector<Edge>& edges) {
  const PlainKernel<Rational> kernel;
  std::vector<EventPlace> result;
  for (std::size_t i = first; i < std::min(last, events.events.size()); ++i) {
    look_for_interrupt();
    const PairEvent& event = events.events[i];
    const Edge &a = edges[event.a], &b = edges[event.b];
    const Rational scale = event_scale(kernel, a, b, event);
    if (event.parallel) {
      result.push_back(common_part(a, b, scale));
    } else {
      result.push_back({scale, point(intersection_at<Rational>(a, b, scale)), {}});
    }
  }
  return result;
}

}  // namespace minkref::inline plane
