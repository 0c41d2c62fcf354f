#include "reference/disc/clearance/disc_passage.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "reference/disc/clearance/level_ways.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline disc {
namespace {

constexpr std::uint32_t none = OffsetPatch::none;

/// The order of two directions on the arc from `first`, at most half a turn long: positive where b
/// comes after a.
template <class N>
int order_on_arc(const Vector<N>& first, const Vector<N>& a, const Vector<N>& b) {
  const int turn = sign(cross(a, b));
  if (turn != 0) return turn;
  if (sign(dot(a, b)) > 0) return 0;
  return sign(dot(first, a)) > 0 ? 1 : -1;
}

/// Decides by intervals around an event's place, or by its roots.
template <class Decide>
int decided(const DiagramEvents& diagram, const DiagramEvent& event, Decide&& decide) {
  try {
    return decide(event.at);
  } catch (const UndecidedSign&) {
    return decide(equidistant_places<RootNumber>(diagram.curves, event.of).at(event.branch).at);
  }
}

Point in_frame(const DiagramEvents& diagram, const Point& p) {
  return {(p.x - diagram.origin.x) * diagram.factor, (p.y - diagram.origin.y) * diagram.factor};
}

}  // namespace

DiscRooms::DiscRooms(const PolygonSet& obstacles, const BuildOptions& options)
    : obstacles_(obstacles), index_(obstacles, options) {
  const DiagramGraph& graph = index_.graph();
  nodes_ = static_cast<std::uint32_t>(graph.events + graph.gaps + graph.reflex_vertices);
  joined_.resize(nodes_ + 1);
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    joined_[a].push_back(b);
    joined_[b].push_back(a);
  };
  for (std::uint32_t k = 0; k < graph.halves.size(); ++k) {
    if (graph.halves[k].twin > k) join(graph.halves[k].from, graph.halves[k].to);
  }
  for (std::uint32_t node = 0; node < nodes_; ++node) {
    if (graph.is_infinite(node)) join(node, infinity());
  }
}

std::uint32_t DiscRooms::number(std::uint32_t node) const {
  return node == infinity() ? index_.radii() + 1 : index_.radius_number(node);
}

/// Whether the foot of a place, which is in front of the half's feature, comes after (positive) the
/// foot of the half's beginning or end.
int DiscRooms::order_on_half(const DiagramHalf& half, bool at_end, const Point& foot,
                             const Point& place) const {
  const DiagramEvents& diagram = index_.diagram();
  const OffsetCurves& curves = diagram.curves;
  const std::uint32_t node = at_end ? half.to : half.from;
  const BoundarySide& side = diagram.walks.sides[at_end ? half.to_side : half.from_side];
  const OffsetCurves::Feature& feature = curves.features[half.feature];
  if (feature.edge != none) {
    const Direction& along = curves.edges[side.edge].along;
    if (index_.graph().is_event(node)) {
      return decided(diagram, diagram.events[node], [&](const auto& at) {
        using N = std::decay_t<decltype(at.x)>;
        return sign(dot(numbers<N>(along), numbers<N>(foot) - at));
      });
    }
    const Point& reflex = curves.features[at_end ? side.to : side.from].centre;
    return sign(dot(along, from_to(reflex, foot)));
  }
  const Direction& first = curves.edges[side.edge].normal;
  const Direction way = from_to(foot, place);
  const auto order = [&](const auto& direction) {
    using N = std::decay_t<decltype(direction.x)>;
    return order_on_arc(numbers<N>(first), direction, numbers<N>(way));
  };
  if (index_.graph().is_event(node)) {
    return decided(diagram, diagram.events[node], [&](const auto& at) {
      using N = std::decay_t<decltype(at.x)>;
      return order(at - numbers<N>(foot));
    });
  }
  const HullGap& gap = diagram.gaps.at(node - index_.graph().events);
  const Direction across =
      from_to(curves.features[gap.from].centre, curves.features[gap.to].centre);
  return order(Vector<Rational>{across.y, Rational(-across.x)});
}

/// The upper node of the half that a place comes to when it moves away from its nearest point; this
/// way is as far from the obstacles as the place, or farther. Infinity where nothing comes.
std::uint32_t DiscRooms::above(const Point& place, const DiscOnPath& largest) const {
  const DiagramEvents& diagram = index_.diagram();
  const OffsetCurves& curves = diagram.curves;
  const Point x = in_frame(diagram, place), foot = in_frame(diagram, largest.contact->touching);
  const Direction way = from_to(foot, x);
  const std::vector<DiagramHalf>& halves = index_.graph().halves;
  std::vector<signed char> is_near(curves.features.size(), -1);
  const auto is_in_front = [&](std::uint32_t number) {
    const OffsetCurves::Feature& feature = curves.features[number];
    if (feature.edge == none) return feature.centre == foot;
    const OffsetEdge& edge = curves.edges[feature.edge];
    return dot(edge.normal, from_to(edge.start, foot)) == 0 && cross(edge.normal, way) == 0 &&
           dot(edge.normal, way) > 0;
  };
  for (std::uint32_t k = 0; k < halves.size(); ++k) {
    const DiagramHalf& half = halves[k];
    signed char& known = is_near[half.feature];
    if (known < 0) known = is_in_front(half.feature) ? 1 : 0;
    if (known == 0 || order_on_half(half, false, foot, x) < 0 ||
        order_on_half(half, true, foot, x) > 0) {
      continue;
    }
    const std::uint32_t upper = index_.rises(k) ? half.to : half.from;
    return index_.graph().is_infinite(upper) ? infinity() : upper;
  }
  check_is_free_beyond(foot, x);
  return infinity();
}

/// All of the set is behind the line through the foot, across the way.
void DiscRooms::check_is_free_beyond(const Point& foot, const Point& place) const {
  const Direction way = from_to(foot, place);
  for (const OffsetEdge& edge : index_.diagram().curves.edges) {
    if (dot(way, from_to(foot, edge.start)) > 0) {
      throw std::logic_error("a place is in front of no part of the diagram");
    }
  }
}

DiscPassage DiscRooms::passage(const Point& from, const std::optional<Point>& to) const {
  const FloatEnvironment standard;
  DiscPassage result;
  const auto largest_at = [&](const Point& place) -> std::optional<DiscOnPath> {
    std::optional<DiscOnPath> found = largest_disc_on_path(obstacles_, {place});
    return found->squared_radius == 0 ? std::nullopt : found;
  };
  result.at_start = largest_at(from);
  if (to) result.at_end = largest_at(*to);
  if (!result.at_start || (to && !result.at_end)) return result;
  const bool is_end_less = to && result.at_end->squared_radius < result.at_start->squared_radius;
  const DiscPassage::Limit at_place =
      is_end_less ? DiscPassage::Limit::end : DiscPassage::Limit::start;
  const DiscIndex::Place least =
      index_.place((is_end_less ? result.at_end : result.at_start)->squared_radius);
  const std::uint32_t start = above(from, *result.at_start),
                      end = to ? above(*to, *result.at_end) : infinity();
  const LevelWays::Found found =
      LevelWays(joined_, [&](auto node) { return number(node); }).find(start, end);
  if (!found.is_connected) return result;
  const bool is_below = found.level < least.gap || (found.level == least.gap && !least.at_event);
  result.limit = is_below ? DiscPassage::Limit::neck : at_place;
  if (is_below) result.necks = found.doors;
  return result;
}

}  // namespace minkref::inline disc
