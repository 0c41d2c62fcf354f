#include "reference/disc/index/offset_history.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "reference/disc/index/radius_level.hpp"
#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

constexpr std::uint32_t none = DiagramGraph::none;

/// Parts of the diagram farther from P than a radius, as that shrinks.
class Parts {
 public:
  explicit Parts(const DiscIndex& index)
      : index_(index),
        graph_(index.graph()),
        outside_(static_cast<std::uint32_t>(nodes())),
        sets_(nodes() + 1),
        last_(nodes() + 1, none),
        of_node_(nodes()) {
    last_[outside_] = outside_;
    for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
      of_node_[graph_.halves[k].from].push_back(k);
    }
  }

  std::vector<OffsetHole> holes() {
    std::vector<std::vector<std::uint32_t>> by_radius(index_.radii() + 2);
    for (std::uint32_t node = 0; node < nodes(); ++node) by_radius[radius(node)].push_back(node);
    for (std::uint32_t k = index_.radii() + 2; k-- > 0;) add(by_radius[k], k);
    // The remaining parts are components of the complement of P.
    for (std::uint32_t node = 0; node < nodes(); ++node) {
      const std::uint32_t root = sets_.root(node);
      if (last_[root] == outside_ || !is_looked_at_.insert(root).second) continue;
      found_.push_back({0, radius(last_[root]), none, last_[root], none});
    }
    return std::move(found_);
  }

 private:
  std::size_t nodes() const { return graph_.events + graph_.gaps + graph_.reflex_vertices; }
  std::uint32_t radius(std::uint32_t node) const { return index_.radius_number(node); }

  /// Adds the nodes at one radius, ascending, to the nodes farther away.
  void add(const std::vector<std::uint32_t>& nodes, std::uint32_t at) {
    if (at == index_.radii() + 1) {
      for (const std::uint32_t node : nodes) join(node, outside_);
      return;
    }
    RadiusLevel level(nodes.size());
    for (std::uint32_t k = 0; k < nodes.size(); ++k) {
      for (const std::uint32_t half : of_node_[nodes[k]]) {
        const std::uint32_t other = graph_.halves[half].to;
        if (radius(other) > at) level.lead(k, sets_.root(other));
        if (radius(other) != at) continue;
        const auto same = std::lower_bound(nodes.begin(), nodes.end(), other);
        level.join(k, static_cast<std::uint32_t>(same - nodes.begin()));
      }
    }
    for (const RadiusLevel::Group& group : level.groups()) {
      const std::uint32_t node = nodes[group.nodes.front()];
      // A greatest value, or the part that keeps its name when parts fall apart.
      const std::uint32_t goes_on =
          group.parts.empty() ? node : last_[split(level, group, nodes, at)];
      for (const std::uint32_t part : group.parts) sets_.join(part, node);
      for (const std::uint32_t k : group.nodes) sets_.join(nodes[k], node);
      last_[sets_.root(node)] = goes_on;
    }
  }

  /// Picks the part that keeps its name when parts fall apart at one radius.
  std::uint32_t split(const RadiusLevel& level, const RadiusLevel::Group& group,
                      const std::vector<std::uint32_t>& nodes, std::uint32_t at) {
    const auto ends_later = [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t x = last_[a], y = last_[b];
      if (x == outside_ || y == outside_) return x == outside_ && y != outside_;
      return radius(x) != radius(y) ? radius(x) > radius(y) : x < y;
    };
    const std::uint32_t goes_on =
        *std::min_element(group.parts.begin(), group.parts.end(), ends_later);
    for (const auto& [part, node] : level.cut_off(group, goes_on)) {
      const std::uint32_t last = last_[part];
      found_.push_back({at, radius(last), nodes[node], last, last_[goes_on]});
    }
    return goes_on;
  }

  /// Keeps the last event of the first.
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t of_a = last_[sets_.root(a)], of_b = last_[sets_.root(b)];
    sets_.join(a, b);
    last_[sets_.root(a)] = of_b != none ? of_b : of_a;
  }

  const DiscIndex& index_;
  const DiagramGraph& graph_;
  std::uint32_t outside_;
  DisjointSets sets_;
  std::vector<std::uint32_t> last_;  ///< by root: where the part ends
  std::vector<std::vector<std::uint32_t>> of_node_;
  std::vector<OffsetHole> found_;
  std::set<std::uint32_t> is_looked_at_;
};

/// Sorts the holes, and replaces the event that names the hole `from` by the hole's number.
void name_holes(std::vector<OffsetHole>& holes) {
  std::sort(holes.begin(), holes.end(), [](const OffsetHole& a, const OffsetHole& b) {
    if (a.birth != b.birth) return a.birth < b.birth;
    return a.end != b.end ? a.end > b.end : a.ends_at < b.ends_at;
  });
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t k = 0; k < holes.size(); ++k) numbers[holes[k].ends_at] = k + 1;
  for (OffsetHole& hole : holes) {
    const auto found = numbers.find(hole.from);
    hole.from = found == numbers.end() ? 0 : found->second;
  }
}

}  // namespace

/// A hole, being an open set, exists at its birth radius.
std::uint32_t OffsetHistory::holes(const DiscIndex::Place& at) const {
  return static_cast<std::uint32_t>(std::count_if(
      all_holes.begin(), all_holes.end(),
      [&](const OffsetHole& hole) { return hole.birth <= at.gap && at.gap < hole.end; }));
}

/// Components that only touch still count separately.
std::uint32_t OffsetHistory::components(const DiscIndex::Place& at) const {
  return polygons - static_cast<std::uint32_t>(
                        std::count_if(joins.begin(), joins.end(), [&](const ComponentJoin& join) {
                          if (at.at_event && join.radius == at.gap) return join.at_radius;
                          return join.radius <= at.gap;
                        }));
}

OffsetHistory offset_history(const DiscIndex& index) {
  const FloatEnvironment standard;
  OffsetHistory history{Parts(index).holes(), {}, 0};
  name_holes(history.all_holes);
  const DiagramGraph& graph = index.graph();
  const DiagramEvents& diagram = index.diagram();
  const auto polygon_of = [&](std::uint32_t side) {
    return diagram.curves.edges[diagram.walks.sides[side].edge].polygon;
  };
  for (const OffsetEdge& edge : diagram.curves.edges) {
    history.polygons = std::max(history.polygons, edge.polygon + 1);
  }
  if (diagram.curves.edges.empty() && !diagram.curves.patches.empty()) history.polygons = 1;
  std::vector<ComponentJoin> all;
  for (const DiagramHalf& half : graph.halves) {
    const std::uint32_t a = polygon_of(half.from_side),
                        b = polygon_of(graph.halves[half.twin].from_side);
    const auto number = static_cast<std::uint32_t>(&half - graph.halves.data());
    if (a >= b) continue;
    const bool is_flat = index.low(number) == index.high(number);
    const std::uint32_t low = is_flat               ? std::min(half.from, half.to)
                              : index.rises(number) ? half.from
                                                    : half.to;
    all.push_back({index.low(number), a, b, graph.is_event(low) ? low : none, is_flat});
  }
  std::sort(all.begin(), all.end(), [](const ComponentJoin& a, const ComponentJoin& b) {
    if (a.radius != b.radius) return a.radius < b.radius;
    if (a.at_radius != b.at_radius) return a.at_radius;
    return std::tie(a.event, a.a, a.b) < std::tie(b.event, b.a, b.b);
  });
  DisjointSets sets(history.polygons);
  for (const ComponentJoin& join : all) {
    if (sets.root(join.a) == sets.root(join.b)) continue;
    sets.join(join.a, join.b);
    history.joins.push_back(join);
  }
  return history;
}

}  // namespace minkref::inline disc
