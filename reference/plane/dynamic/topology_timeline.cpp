#include "reference/plane/dynamic/topology_timeline.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <unordered_map>

#include "reference/fault.hpp"
#include "reference/plane/dynamic/boundary_regions.hpp"

namespace minkref {
namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// The regions of one kind that a state has, and which of them each of its links bounds.
struct Side {
  const std::vector<std::uint32_t>& of_link;
  std::uint32_t first,
      last;  ///< numbers of the regions, first to last - 1; 0 is always the outside
};

Side side(const BoundaryRegions& regions, FeatureKind kind) {
  return kind == FeatureKind::hole ? Side{regions.hole, 0, regions.holes + 1}
                                   : Side{regions.component, 0, regions.components};
}

/// Regions before, at and after a scale, linked where they share a piece of boundary.
struct Relation {
  std::vector<std::set<std::uint32_t>> at_of_before, at_of_after;
};

class TimelineBuilder {
 public:
  TimelineBuilder(const BoundaryStates& states, const std::function<void(RingsFrom)>& rings)
      : states_(states),
        rings_(rings),
        events_(*states.timeline().events),
        finder_(events_.moving()),
        sub_edges_(states.sub_edges_in(0)) {}

  TopologyTimeline build() {
    const auto& groups = states_.groups();
    below_ = between(groups.empty() ? 0 : groups.front());
    for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) {
      auto& names = names_[index(kind)];
      const Side regions = side(below_, kind);
      for (std::uint32_t r = regions.first; r < regions.last; ++r) {
        names.push_back(r);
        features(kind).push_back({});
      }
      if (kind == FeatureKind::hole && names.empty()) {
        names.push_back(0);
        features(kind).push_back({});
      }
    }
    count(groups.empty() ? 0 : groups.front(), below_);
    show_rings(0);
    for (const std::uint32_t group : groups) pass(group);
    return std::move(result_);
  }

 private:
  static std::size_t index(FeatureKind kind) { return static_cast<std::size_t>(kind); }
  std::vector<Feature>& features(FeatureKind kind) {
    return kind == FeatureKind::hole ? result_.holes : result_.components;
  }

  /// A scale within an interval.
  Rational within(std::uint32_t interval) const {
    const ScaleWindow& window = events_.window();
    const bool first = interval == 0, last = interval == events_.groups();
    const Rational low = !first ? events_.exact(interval - 1) : window.from.value_or(0);
    const Rational high = !last ? events_.exact(interval) : window.to.value_or(2 * low + 1);
    return (low + high) / 2;
  }

  BoundaryRegions between(std::uint32_t interval) {
    return boundary_regions(states_, states_.between(sub_edges_), finder_, within(interval));
  }

  void count(std::uint32_t interval, const BoundaryRegions& at) {
    result_.counts.push_back({interval, below_.holes, below_.components,
                              static_cast<std::uint32_t>(below_.edges.size()), at.holes,
                              at.components});
  }

  void show_rings(std::uint32_t interval) {
    if (!rings_) return;
    RingsFrom state{interval, boundary_rings(below_, finder_)};
    for (BoundaryRing& ring : state.rings) {
      ring.hole = names_[index(FeatureKind::hole)][ring.hole];
      ring.component = names_[index(FeatureKind::component)][ring.component];
    }
    rings_(std::move(state));
  }

  void pass(std::uint32_t group) {
    const Rational scale = events_.exact(group);
    const std::vector<std::uint32_t> before = sub_edges_;
    BoundaryState at_scale = states_.at_group(group, before);
    const std::vector<BoundaryLink> at_links = at_scale.links;
    const BoundaryRegions here = boundary_regions(states_, std::move(at_scale), finder_, scale);
    std::erase_if(sub_edges_,
                  [&](std::uint32_t s) { return states_.timeline().sub_edges[s].last == group; });
    const auto& fresh = states_.begin_with(group + 1);
    sub_edges_.insert(sub_edges_.end(), fresh.begin(), fresh.end());
    const std::vector<std::uint32_t>& after = sub_edges_;
    BoundaryRegions above = between(group + 1);

    // Where each sub-edge stands among the links.
    const auto places = [&](const std::vector<std::uint32_t>& sub_edges,
                            const BoundaryRegions& regions) {
      std::unordered_map<std::uint32_t, std::uint32_t> place;
      place.reserve(sub_edges.size());
      for (std::size_t i = 0; i < sub_edges.size(); ++i) place[sub_edges[i]] = regions.place[i];
      return place;
    };
    bool changed = false;
    const auto known = std::pair(places(before, below_), places(after, above));
    for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) {
      const Side b = side(below_, kind), h = side(here, kind), a = side(above, kind);
      Relation relation{std::vector<std::set<std::uint32_t>>(b.last),
                        std::vector<std::set<std::uint32_t>>(a.last)};
      for (std::size_t i = 0; i < at_links.size(); ++i) {
        const std::uint32_t region = h.of_link[here.place[i]];
        if (at_links[i].before != no_sub_edge) {
          relation.at_of_before[b.of_link[known.first.at(at_links[i].before)]].insert(region);
        }
        if (at_links[i].after != no_sub_edge) {
          relation.at_of_after[a.of_link[known.second.at(at_links[i].after)]].insert(region);
        }
      }
      if (kind == FeatureKind::hole) {
        relation.at_of_before[0].insert(0);
        relation.at_of_after[0].insert(0);
      } else {
        find_swallowed(relation.at_of_before, below_, here, scale);
        find_swallowed(relation.at_of_after, above, here, scale);
      }
      changed = relate(kind, relation, h.last, group, scale, here, above) || changed;
    }
    const bool event = boundary_event(group, scale, here, above, changed);
    below_ = std::move(above);
    if (event) show_rings(group + 1);
    count(group + 1, here);
  }

  /// Components whose whole boundary is inside another at the scale: an island that fills its hole.
  /// (None shrinks to a point: it holds the sum of two triangles.)
  void find_swallowed(std::vector<std::set<std::uint32_t>>& at_of, const BoundaryRegions& regions,
                      const BoundaryRegions& here, const Rational& scale) const {
    for (std::size_t i = 0; i < regions.links.size(); ++i) {
      const std::uint32_t component = regions.component[i];
      if (!at_of[component].empty()) continue;
      const Point from = states_.tracks()[regions.links[i].from].at(scale);
      const Point to = states_.tracks()[regions.links[i].to].at(scale);
      if (from == to) continue;
      const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
      at_of[component].insert(component_around(states_, here, middle, scale));
    }
  }

  /// Carries the names across; reports what is not one to one. Whether there was anything.
  bool relate(FeatureKind kind, const Relation& relation, std::uint32_t at_count,
              std::uint32_t group, const Rational& scale, const BoundaryRegions& here,
              const BoundaryRegions& above) {
    auto& names = names_[index(kind)];
    const auto old = names;
    names.assign(relation.at_of_after.size(), none);
    // Clusters of regions that hang together.
    std::vector<std::uint32_t> cluster(at_count);
    std::iota(cluster.begin(), cluster.end(), 0U);
    const auto find = [&](std::uint32_t x) {
      while (cluster[x] != x) x = cluster[x];
      return x;
    };
    for (const auto* sets : {&relation.at_of_before, &relation.at_of_after}) {
      for (const auto& set : *sets) {
        for (const std::uint32_t x : set) cluster[find(x)] = find(*set.begin());
      }
    }
    struct Members {
      std::vector<std::uint32_t> before, at, after;
    };
    std::map<std::uint32_t, Members> clusters;
    for (std::uint32_t x = 0; x < at_count; ++x) clusters[find(x)].at.push_back(x);
    bool changed = false;
    for (std::uint32_t b = 0; b < relation.at_of_before.size(); ++b) {
      if (!relation.at_of_before[b].empty()) {
        clusters[find(*relation.at_of_before[b].begin())].before.push_back(b);
        continue;
      }
      features(kind)[old[b]].died = group;
      result_.topology.push_back({group,
                                  kind,
                                  TopologyEvent::Change::death,
                                  {old[b]},
                                  {},
                                  0,
                                  vanishing_place(kind, below_, b, scale)});
      changed = true;
    }
    for (std::uint32_t a = 0; a < relation.at_of_after.size(); ++a) {
      if (!relation.at_of_after[a].empty()) {
        clusters[find(*relation.at_of_after[a].begin())].after.push_back(a);
        continue;
      }
      names[a] = fresh(kind, group);
      result_.topology.push_back({group,
                                  kind,
                                  TopologyEvent::Change::birth,
                                  {},
                                  {names[a]},
                                  0,
                                  vanishing_place(kind, above, a, scale)});
      changed = true;
    }
    for (auto& [root, members] : clusters) {
      if (members.before.size() == 1 && members.after.size() == 1) {
        names[members.after[0]] = old[members.before[0]];
        if (members.at.size() == 1 || planted(Fault::touch_overlooked)) continue;
        changed = true;
        result_.topology.push_back({group,
                                    kind,
                                    TopologyEvent::Change::touch,
                                    {old[members.before[0]]},
                                    {names[members.after[0]]},
                                    members.at.size(),
                                    pinch(kind, members.at, here, scale)});
        continue;
      }
      changed = true;
      // The oldest go on, as the largest.
      std::vector<std::uint32_t> elders;
      for (const std::uint32_t b : members.before) elders.push_back(old[b]);
      std::sort(elders.begin(), elders.end());
      order_by_size(kind, members.after, relation, here, scale);
      for (std::size_t i = 0; i < members.after.size(); ++i) {
        names[members.after[i]] = i < elders.size() ? elders[i] : fresh(kind, group);
      }
      for (std::size_t i = members.after.size(); i < elders.size(); ++i) {
        features(kind)[elders[i]].died = group;
      }
      TopologyEvent event{group,
                          kind,
                          TopologyEvent::Change::split,
                          elders,
                          {},
                          members.at.size(),
                          pinch(kind, members.at, here, scale)};
      if (members.before.size() > members.after.size()) event.change = TopologyEvent::Change::merge;
      for (const std::uint32_t a : members.after) event.after.push_back(names[a]);
      result_.topology.push_back(std::move(event));
    }
    return changed;
  }

  std::uint32_t fresh(FeatureKind kind, std::uint32_t group) {
    features(kind).push_back({group, {}});
    return static_cast<std::uint32_t>(features(kind).size() - 1);
  }

  /// The outside first, then by the area that they have at the scale, largest first.
  void order_by_size(FeatureKind kind, std::vector<std::uint32_t>& after, const Relation& relation,
                     const BoundaryRegions& here, const Rational& scale) const {
    if (after.size() < 2) return;
    const Side regions = side(here, kind);
    std::map<std::uint32_t, Rational> doubled;
    for (std::size_t i = 0; i < here.links.size(); ++i) {
      const Point a = states_.tracks()[here.links[i].from].at(scale);
      const Point b = states_.tracks()[here.links[i].to].at(scale);
      doubled[regions.of_link[i]] += a.x * b.y - a.y * b.x;
    }
    std::map<std::uint32_t, Rational> size;
    for (const std::uint32_t a : after) {
      for (const std::uint32_t region : relation.at_of_after[a]) size[a] += abs(doubled[region]);
    }
    std::stable_sort(after.begin(), after.end(), [&](std::uint32_t x, std::uint32_t y) {
      const bool outside_x = kind == FeatureKind::hole && x == 0;
      const bool outside_y = kind == FeatureKind::hole && y == 0;
      if (planted(Fault::smallest_part_goes_on)) std::swap(x, y);
      return outside_x != outside_y ? outside_x : size[x] > size[y];
    });
  }

  /// A point that a region shrinks to, or grows from.
  Point vanishing_place(FeatureKind kind, const BoundaryRegions& regions, std::uint32_t region,
                        const Rational& scale) const {
    std::optional<Point> least;
    const Side of = side(regions, kind);
    for (std::size_t i = 0; i < regions.links.size(); ++i) {
      if (of.of_link[i] != region) continue;
      const Point p = states_.tracks()[regions.links[i].from].at(scale);
      if (!least || p.x < least->x || (p.x == least->x && p.y < least->y)) least = p;
    }
    return least.value_or(Point{});
  }

  /// A point where regions touch one another or themselves.
  Point pinch(FeatureKind kind, const std::vector<std::uint32_t>& regions,
              const BoundaryRegions& here, const Rational& scale) const {
    const Side of = side(here, kind);
    std::map<std::uint32_t, std::size_t> seen;
    for (std::size_t i = 0; i < here.links.size(); ++i) {
      const auto& link = here.links[i];
      if (std::find(regions.begin(), regions.end(), of.of_link[i]) == regions.end()) continue;
      if (std::find(here.pinches.begin(), here.pinches.end(), link.from) == here.pinches.end()) {
        continue;
      }
      ++seen[link.from];
    }
    for (const auto& [point, times] : seen) {
      if (times > 1) return states_.tracks()[point].at(scale);
    }
    const auto location = events_.locate(scale);
    return block_place(location.before, scale).value_or(Point{});
  }

  bool boundary_event(std::uint32_t group, const Rational& scale, const BoundaryRegions& here,
                      const BoundaryRegions& above, bool topology_changed) {
    const bool same = below_.edges == above.edges;
    if (same && !topology_changed && here.pinches.size() == below_.pinches.size()) {
      return false;
    }
    BoundaryEvent event;
    event.group = group;
    const std::size_t old_size = below_.edges.size(), new_size = above.edges.size();
    event.change = same                  ? BoundaryEvent::Change::touch
                   : new_size > old_size ? BoundaryEvent::Change::birth
                   : new_size < old_size ? BoundaryEvent::Change::death
                                         : BoundaryEvent::Change::swap;
    // Vertices that are not on both sides, and the edges there.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> different;
    std::set_symmetric_difference(below_.edges.begin(), below_.edges.end(), above.edges.begin(),
                                  above.edges.end(), std::back_inserter(different));
    std::set<std::uint32_t> edges;
    for (const CoincidentNodes& block : blocks(group)) {
      edges.insert(block.edge);
      for (const std::uint32_t node : block.nodes) {
        if (node != start_of_edge && node != end_of_edge) {
          edges.insert(events_.table().nodes[node].other);
        }
      }
    }
    // A ring that vanishes or appears in a point leaves no such node.
    for (const auto& list : {states_.end_with(group), states_.begin_with(group + 1)}) {
      for (const std::uint32_t s : list) edges.insert(states_.timeline().sub_edges[s].edge);
    }
    event.edges.assign(edges.begin(), edges.end());
    const auto place = block_place(group, scale);
    if (place) {
      event.place = *place;
    } else if (!different.empty()) {
      event.place = states_.tracks()[different.front().first].at(scale);
    }
    result_.boundary.push_back(std::move(event));
    return true;
  }

  std::span<const CoincidentNodes> blocks(std::uint32_t group) const {
    const auto& all = states_.timeline().coincident;
    const auto first = std::partition_point(
        all.begin(), all.end(), [&](const CoincidentNodes& b) { return b.group < group; });
    auto last = first;
    while (last != all.end() && last->group == group) ++last;
    return {first, last};
  }
  std::optional<Point> block_place(std::uint32_t group, const Rational& scale) const {
    const auto here = blocks(group);
    if (here.empty()) return std::nullopt;
    return states_.timeline().track(here[0].edge, here[0].nodes[0]).at(scale);
  }
  const BoundaryStates& states_;
  const std::function<void(RingsFrom)>& rings_;
  const ArrangementEvents& events_;
  CycleFinder finder_;
  std::vector<std::uint32_t> sub_edges_;
  BoundaryRegions below_;
  std::array<std::vector<std::uint32_t>, 2> names_;  ///< feature of each region, by kind
  TopologyTimeline result_;
};

}  // namespace

TopologyTimeline topology_timeline(const BoundaryStates& states,
                                   const std::function<void(RingsFrom)>& rings) {
  return TimelineBuilder(states, rings).build();
}

}  // namespace minkref
