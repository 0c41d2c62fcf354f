#include "reference/disc/diagram/diagram_graph.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

constexpr std::uint32_t none = DiagramGraph::none;
const Direction left{-1, 0};

/// A node's nearest point: at a vertex, or inside an edge; right in front of an edge's end, at
/// both.
struct Way {
  std::uint32_t feature;      ///< of a vertex, where there is one
  std::uint32_t line = none;  ///< of a vertex: the line that the node is right in front of, too
};

/// An event with its exact place, computed on demand.
class PlacedEvent {
 public:
  PlacedEvent(const OffsetCurves& curves, const DiagramEvent& event)
      : curves_(&curves), event_(&event) {
    for (const std::uint32_t feature : event.features) {
      const auto is_line_of = [&](const auto& joint) { return joint.first == feature; };
      if (std::any_of(event.joints.begin(), event.joints.end(), is_line_of)) continue;
      Way way{feature};
      for (const auto& [line, end] : event.joints) {
        if (end == feature) way.line = line;
      }
      ways_.push_back(way);
    }
    sort_ways();
  }

  const DiagramEvent& event() const { return *event_; }
  /// Clockwise, as seen from the event.
  const std::vector<Way>& ways() const { return ways_; }
  const RootPoint& at() const {
    if (!exact_) exact_ = equidistant_places<RootNumber>(*curves_, event_->of)[event_->branch].at;
    return *exact_;
  }

  template <class InIntervals, class Exact>
  int sign_of(InIntervals&& in_intervals, Exact&& by_roots) const {
    if (const auto certain = certified_sign(in_intervals(event_->at))) return *certain;
    return sign(by_roots(at()));
  }
  /// How far along a vector from a point.
  int sign_along(const Direction& along, const Point& from) const {
    return sign_of(
        [&](const auto& x) { return dot(numbers<Interval>(along), x - numbers<Interval>(from)); },
        [&](const auto& x) {
          return dot(numbers<RootNumber>(along), x - numbers<RootNumber>(from));
        });
  }

 private:
  template <class N>
  Vector<N> direction(const Way& way, const Vector<N>& from) const {
    const Site own = Site::of(*curves_, way.feature);
    if (own.is_point) return numbers<N>(own.point) - from;
    return N(-1) * numbers<N>(own.normal);
  }

  void sort_ways() {
    const Way first = ways_.front();
    const auto turn = [&](const Way& a, const Way& b) {
      const auto of = [&](const auto& x) { return cross(direction(a, x), direction(b, x)); };
      return sign_of(of, of);
    };
    // Clockwise from the first way: on the right, opposite, on the left.
    std::vector<std::pair<int, Way>> others;
    for (std::size_t k = 1; k < ways_.size(); ++k) {
      others.emplace_back(turn(first, ways_[k]), ways_[k]);
    }
    std::sort(others.begin(), others.end(), [&](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : turn(a.second, b.second) < 0;
    });
    for (std::size_t k = 0; k < others.size(); ++k) ways_[k + 1] = others[k].second;
  }

  const OffsetCurves* curves_;
  const DiagramEvent* event_;
  std::vector<Way> ways_;
  mutable std::optional<RootPoint> exact_;
};

/// The boundary position of a node's nearest point.
struct Position {
  std::uint32_t side;
  int slot;      ///< on an arc: at its start, below, at and above a right angle, at its end
  Interval key;  ///< grows along the slot
  std::uint32_t node, way;
};

class Builder {
 public:
  explicit Builder(const DiagramEvents& diagram)
      : diagram_(diagram), curves_(diagram.curves), sides_(diagram.walks.sides) {
    sides_of_.resize(curves_.features.size());
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
      const BoundarySide& side = sides_[k];
      sides_of_[side.feature].push_back(k);
    }
    for (const DiagramEvent& event : diagram.events) events_.emplace_back(curves_, event);
  }

  DiagramGraph build() {
    graph_.events = events_.size();
    graph_.gaps = diagram_.gaps.size();
    graph_.reflex_vertices = 0;
    place_events();
    place_gaps();
    place_leftmost();
    std::sort(positions_.begin(), positions_.end(),
              [&](const Position& a, const Position& b) { return is_before(a, b); });
    std::size_t at = 0;
    for (std::uint32_t number = 0; number < diagram_.walks.walks.size(); ++number) {
      const BoundaryWalk& walk = diagram_.walks.walks[number];
      std::vector<Position> all;
      std::vector<std::pair<std::uint32_t, std::size_t>> marks;  // polygons, and entries before
      for (std::uint32_t side = walk.first; side < walk.last; ++side) {
        for (; at < positions_.size() && positions_[at].side == side; ++at) {
          if (positions_[at].node == none) {
            marks.emplace_back(positions_[at].way, all.size());
          } else {
            all.push_back(positions_[at]);
          }
        }
        if (!sides_[side].ends_at_reflex) continue;
        const std::uint32_t node = first_reflex() + graph_.reflex_vertices++;
        all.push_back({side, 0, Interval(0), node, 1});
        all.push_back({after(walk, side), 0, Interval(0), node, 0});
      }
      const std::vector<std::uint32_t> started = add_walk(walk, all);
      for (const auto& [polygon, before] : marks) {
        graph_.leftmost[polygon].walk = number;
        const DiagramGraph::Walk& own = graph_.walks.back();
        if (own.first == own.last) continue;
        const std::uint32_t next = started[before];
        graph_.leftmost[polygon].half = next == own.first ? own.last - 1 : next - 1;
      }
    }
    find_twins();
    return std::move(graph_);
  }

 private:
  std::uint32_t first_reflex() const {
    return static_cast<std::uint32_t>(graph_.events + graph_.gaps);
  }
  std::uint32_t ways_of(std::uint32_t node) const {
    return graph_.is_event(node) ? static_cast<std::uint32_t>(events_[node].ways().size()) : 2;
  }

  void place_events() {
    for (std::uint32_t node = 0; node < events_.size(); ++node) {
      const PlacedEvent& event = events_[node];
      for (std::uint32_t way = 0; way < event.ways().size(); ++way) {
        Position position = of_way(event, event.ways()[way]);
        position.node = node;
        position.way = way;
        positions_.push_back(position);
      }
    }
  }

  Position of_way(const PlacedEvent& event, const Way& way) const {
    const std::vector<std::uint32_t>& sides = sides_of_[way.feature];
    if (curves_.features[way.feature].edge != OffsetPatch::none) {
      const std::uint32_t side = sides.size() == 1 ? sides[0] : side_below(event, sides);
      return {side, 0, key<Interval>(side, event.event().at), 0, 0};
    }
    const std::uint32_t arc = sides.at(0);
    if (way.line == curves_.edges[sides_[arc].edge].feature) return {arc, 0, Interval(0), 0, 0};
    if (way.line != none) return {arc, 4, Interval(0), 0, 0};
    const Direction& normal = curves_.edges[sides_[arc].edge].normal;
    const int slot = 2 - event.sign_along(normal, curves_.features[way.feature].centre);
    return {arc, slot, slot == 2 ? Interval(0) : key<Interval>(arc, event.event().at), 0, 0};
  }

  /// The side in front of which an event lies, among several sides on one line.
  std::uint32_t side_below(const PlacedEvent& event,
                           const std::vector<std::uint32_t>& sides) const {
    for (const std::uint32_t side : sides) {
      const Direction& along = curves_.edges[sides_[side].edge].along;
      if (event.sign_along(along, curves_.features[sides_[side].from].centre) > 0 &&
          event.sign_along(along, curves_.features[sides_[side].to].centre) <= 0) {
        return side;
      }
    }
    throw std::logic_error("an event is in front of no side of its line");
  }

  /// How far along an edge; for an arc, the tangent of the angle from the start.
  template <class N>
  N key(std::uint32_t side, const Vector<N>& at) const {
    const OffsetEdge& edge = curves_.edges[sides_[side].edge];
    if (!sides_[side].is_arc) return dot(numbers<N>(edge.along), at - numbers<N>(edge.start));
    const Vector<N> way = at - numbers<N>(edge.end), normal = numbers<N>(edge.normal);
    return cross(normal, way) / dot(normal, way);
  }

  void place_gaps() {
    for (std::uint32_t k = 0; k < diagram_.gaps.size(); ++k) {
      const HullGap& gap = diagram_.gaps[k];
      for (const std::uint32_t way : {0U, 1U}) {
        const std::uint32_t arc = sides_of_[way == 0 ? gap.from : gap.to].at(0);
        positions_.push_back(
            in_direction(arc, out_of(k), static_cast<std::uint32_t>(graph_.events) + k, way));
      }
    }
  }
  Direction out_of(std::uint32_t gap) const {
    const Direction way = from_to(curves_.features[diagram_.gaps[gap].from].centre,
                                  curves_.features[diagram_.gaps[gap].to].centre);
    return {way.y, -way.x};
  }

  /// Only where an arc looks to the left.
  void place_leftmost() {
    for (const OffsetEdge& edge : curves_.edges) {
      if (edge.polygon >= graph_.leftmost.size()) {
        graph_.leftmost.resize(edge.polygon + 1, {none, none, none});
      }
      std::uint32_t& least = graph_.leftmost[edge.polygon].vertex;
      const Point& at = edge.start;
      if (least == none || at.x < curves_.features[least].centre.x ||
          (at.x == curves_.features[least].centre.x && at.y < curves_.features[least].centre.y)) {
        least = edge.start_feature;
      }
    }
    for (std::uint32_t polygon = 0; polygon < graph_.leftmost.size(); ++polygon) {
      const std::uint32_t vertex = graph_.leftmost[polygon].vertex;
      if (sides_of_[vertex].empty()) continue;
      const std::uint32_t arc = sides_of_[vertex].at(0);
      const Direction& from = curves_.edges[sides_[arc].edge].normal;
      const Direction& to = curves_.edges[sides_[arc].next].normal;
      if (cross(from, left) < 0 || cross(left, to) < 0) continue;
      positions_.push_back(in_direction(arc, left, none, polygon));
    }
  }

  /// On an arc.
  Position in_direction(std::uint32_t arc, const Direction& out, std::uint32_t node,
                        std::uint32_t way) const {
    const Direction& normal = curves_.edges[sides_[arc].edge].normal;
    const Rational along = dot(normal, out);
    const Rational key = along == 0 ? Rational(0) : Rational(cross(normal, out) / along);
    return {arc, 2 - sign(along), Interval(key), node, way};
  }

  RootNumber exact_key(const Position& position) const {
    if (graph_.is_event(position.node)) return key(position.side, events_[position.node].at());
    const Direction out = position.node == none
                              ? left
                              : out_of(position.node - static_cast<std::uint32_t>(graph_.events));
    const Direction& normal = curves_.edges[sides_[position.side].edge].normal;
    return RootNumber(Rational(cross(normal, out) / dot(normal, out)));
  }

  bool is_before(const Position& a, const Position& b) const {
    if (a.side != b.side) return a.side < b.side;
    if (a.slot != b.slot) return a.slot < b.slot;
    if (a.key.upper() < b.key.lower()) return true;
    if (b.key.upper() < a.key.lower() || (a.node == b.node && a.way == b.way)) return false;
    const bool is_one_place = sides_[a.side].is_arc && a.slot % 2 == 0;
    const int order = is_one_place ? 0 : compare(exact_key(a), exact_key(b));
    // Two gaps on one side of the hull: nothing lies between.
    return order != 0 ? order < 0 : a.way > b.way;
  }

  /// Adds the halves between consecutive nodes. None goes on from a reflex vertex, or from
  /// infinity, behind the second way. Returns how many halves precede each node, and the total.
  std::vector<std::uint32_t> add_walk(const BoundaryWalk& walk, const std::vector<Position>& all) {
    const auto first = static_cast<std::uint32_t>(graph_.halves.size());
    std::vector<std::uint32_t> started;
    for (std::size_t k = 0; k < all.size(); ++k) {
      started.push_back(static_cast<std::uint32_t>(graph_.halves.size()));
      const Position &from = all[k], &to = all[(k + 1) % all.size()];
      if (!graph_.is_event(from.node) && from.way == 1) {
        if (graph_.is_event(to.node) || to.way != 0) {
          throw std::logic_error("a part of a diagram starts at infinity");
        }
        continue;
      }
      const bool is_behind = sides_[from.side].is_arc && from.slot == 4;
      const bool is_at_start = sides_[to.side].is_arc && to.slot == 0;
      const std::uint32_t side = is_behind ? after(walk, from.side) : from.side,
                          last = is_at_start ? before(walk, to.side) : to.side;
      if (sides_[side].feature != sides_[last].feature) {
        throw std::logic_error("a part of a diagram is in front of two features");
      }
      starts_.push_back({from.node, from.way});
      ends_.push_back({to.node, (to.way + ways_of(to.node) - 1) % ways_of(to.node)});
      graph_.halves.push_back({from.node, to.node, none, sides_[side].feature, side, last});
    }
    started.push_back(static_cast<std::uint32_t>(graph_.halves.size()));
    graph_.walks.push_back({first, started.back()});
    return started;
  }

  static std::uint32_t after(const BoundaryWalk& walk, std::uint32_t side) {
    return side + 1 == walk.last ? walk.first : side + 1;
  }
  static std::uint32_t before(const BoundaryWalk& walk, std::uint32_t side) {
    return side == walk.first ? walk.last - 1 : side - 1;
  }

  /// A half starts behind one way of a node, clockwise, and the half's twin ends there.
  void find_twins() {
    const auto halves = static_cast<std::uint32_t>(graph_.halves.size());
    std::vector<std::uint32_t> order(halves);
    for (std::uint32_t k = 0; k < halves; ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return starts_[a] < starts_[b]; });
    for (std::uint32_t k = 0; k < halves; ++k) {
      const auto found = std::lower_bound(order.begin(), order.end(), ends_[k],
                                          [&](auto a, const auto& b) { return starts_[a] < b; });
      if (found == order.end() || starts_[*found] != ends_[k] || ends_[*found] != starts_[k]) {
        throw std::logic_error("a part of a diagram has one side only");
      }
      graph_.halves[k].twin = *found;
    }
  }

  const DiagramEvents& diagram_;
  const OffsetCurves& curves_;
  const std::vector<BoundarySide>& sides_;
  std::vector<std::vector<std::uint32_t>> sides_of_;  ///< by feature
  std::vector<PlacedEvent> events_;
  std::vector<Position> positions_;
  DiagramGraph graph_{};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> starts_, ends_;  ///< node and way
};

}  // namespace

DiagramGraph diagram_graph(const DiagramEvents& diagram) {
  const FloatEnvironment standard;
  return Builder(diagram).build();
}

}  // namespace minkref::inline disc
