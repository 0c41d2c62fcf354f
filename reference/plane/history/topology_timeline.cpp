#include "reference/plane/history/topology_timeline.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/history/boundary_changes.hpp"

namespace minkref::inline plane {
namespace {

/// A state's regions of one kind, and the region that each link bounds.
struct Side {
  const std::vector<std::uint32_t>& of_link;
  std::uint32_t first,
      last;  ///< numbers of the regions, first to last - 1; 0 is always the outside
};

Side side(const BoundaryRegions& regions, FeatureKind kind) {
  return kind == FeatureKind::hole ? Side{regions.hole, 0, regions.holes + 1}
                                   : Side{regions.component, 0, regions.components};
}

/// Regions before, at and after a scale, linked if they share a piece of boundary.
struct Relation {
  std::vector<std::set<std::uint32_t>> at_of_before, at_of_after;
};

class TimelineBuilder {
 public:
  TimelineBuilder(const BoundaryHistory& history, const std::function<void(RingsFrom)>& rings,
                  const std::function<void(FeaturesFrom)>& features)
      : history_(history),
        show_rings_(rings),
        show_features_(features),
        finder_(history.moving()),
        changes_(history),
        present_(history.sub_edges_in(0)),
        place_below_(history.sub_edges().size()),
        place_above_(history.sub_edges().size()) {}

  TopologyTimeline build() {
    const auto& groups = history_.groups();
    below_ = between(groups.empty() ? 0 : groups.front());
    place(present_, below_, place_below_);
    for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) name_first(kind);
    count(groups.empty() ? 0 : groups.front(), below_);
    show_rings(0);
    show_features(0);
    for (const std::uint32_t group : groups) {
      look_for_interrupt_now();
      if (const auto quiet = history_.quiet(group)) {
        skip(group, *quiet);
      } else {
        pass(group);
      }
    }
    return std::move(result_);
  }

 private:
  static std::size_t index(FeatureKind kind) { return static_cast<std::size_t>(kind); }
  std::vector<Feature>& features(FeatureKind kind) {
    return kind == FeatureKind::hole ? result_.holes : result_.components;
  }

  /// A region's left and right extent just above a scale: the least and the greatest of its
  /// vertices by x, the slope of x, y, the slope of y. Cuts of the region's sides do not matter.
  struct Extent {
    using Germ = std::array<Rational, 4>;
    std::optional<Germ> least, greatest;
    auto operator<=>(const Extent& other) const {
      return std::pair(least, greatest) <=> std::pair(other.least, other.greatest);
    }
  };
  std::vector<Extent> extents(FeatureKind kind, const BoundaryRegions& regions,
                              const Rational& scale) const {
    const Side of = side(regions, kind);
    std::vector<Extent> result(of.last);
    for (std::size_t i = 0; i < regions.links.size(); ++i) {
      const Track& track = history_.tracks()[regions.links[i].from];
      const Point p = track.at(scale);
      const Extent::Germ germ{p.x, track.b.x, p.y, track.b.y};
      Extent& own = result[of.of_link[i]];
      if (!own.least || germ < *own.least) own.least = germ;
      if (!own.greatest || germ > *own.greatest) own.greatest = germ;
    }
    return result;
  }

  /// Names the first state's regions, ordered by extent just above the window's start.
  void name_first(FeatureKind kind) {
    const auto extent = extents(kind, below_, history_.window().from.value_or(Rational(0)));
    const std::uint32_t fixed = kind == FeatureKind::hole ? 1 : 0;  // the outside comes first
    std::vector<std::uint32_t> order(extent.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin() + std::min<std::ptrdiff_t>(fixed, std::ssize(order)), order.end(),
              [&](std::uint32_t x, std::uint32_t y) { return extent[x] < extent[y]; });
    auto& names = names_[index(kind)];
    names.resize(extent.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) names[order[k]] = k;
    features(kind).resize(order.size());
  }

  /// A scale within an interval.
  Rational within(std::uint32_t interval) const {
    const ScaleWindow& window = history_.window();
    const bool first = interval == 0, last = interval == history_.group_count();
    const Rational low = !first ? history_.scale(interval - 1) : window.from.value_or(0);
    const Rational high = !last ? history_.scale(interval) : window.to.value_or(2 * low + 1);
    return (low + high) / 2;
  }

  BoundaryRegions between(std::uint32_t interval) {
    return boundary_regions(history_.tracks(), history_.between(present_), finder_,
                            within(interval));
  }

  void count(std::uint32_t interval, const BoundaryRegions& at) {
    result_.counts.push_back({interval, below_.holes, below_.components,
                              static_cast<std::uint32_t>(below_.edges.size()), at.holes,
                              at.components});
  }

  void show_rings(std::uint32_t interval) {
    if (!show_rings_) return;
    RingsFrom state{interval, boundary_rings(below_, finder_)};
    for (BoundaryRing& ring : state.rings) {
      ring.hole = names_[index(FeatureKind::hole)][ring.hole];
      ring.component = names_[index(FeatureKind::component)][ring.component];
    }
    show_rings_(std::move(state));
  }

  void show_features(std::uint32_t interval) {
    if (!show_features_) return;
    FeaturesFrom state{interval, present_, {}, {}};
    for (const std::uint32_t s : present_) {
      const std::uint32_t link = place_below_[s];
      state.holes.push_back(names_[index(FeatureKind::hole)][below_.hole[link]]);
      state.components.push_back(names_[index(FeatureKind::component)][below_.component[link]]);
    }
    show_features_(std::move(state));
  }

  /// Finds each sub-edge's place among the links.
  static void place(const std::vector<std::uint32_t>& sub_edges, const BoundaryRegions& regions,
                    std::vector<std::uint32_t>& places) {
    for (std::size_t i = 0; i < sub_edges.size(); ++i) places[sub_edges[i]] = regions.place[i];
  }

  void move_on(std::uint32_t group) {
    std::vector<std::uint32_t> ended = history_.end_with(group);
    std::sort(ended.begin(), ended.end());
    std::erase_if(present_, [&](std::uint32_t s) {
      return std::binary_search(ended.begin(), ended.end(), s);
    });
    const auto& fresh = history_.begin_with(group + 1);
    present_.insert(present_.end(), fresh.begin(), fresh.end());
  }

  /// Over a group that changes no feature.
  void skip(std::uint32_t group, const BoundaryHistory::Quiet& quiet) {
    if (!stale_) {
      for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) {
        auto& of_ring = name_of_ring_[index(kind)];
        of_ring.clear();
        const Side regions = side(below_, kind);
        for (const std::uint32_t s : present_) {
          of_ring[history_.ring_of(s, group)] =
              names_[index(kind)][regions.of_link[place_below_[s]]];
        }
      }
      stale_ = true;
    }
    move_on(group);
    auto change = changes_.at(group, history_.at_group(group));
    if (quiet.change && !change) throw std::logic_error("vertices of the boundary jump");
    if (!change) return;
    result_.boundary.push_back({group, quiet.change.value_or(BoundaryEvent::Change::touch),
                                std::move(change->edges), change->place});
  }

  /// The state below a group again, after groups that were skipped.
  void refresh(std::uint32_t group) {
    stale_ = false;
    below_ = between(group);
    place(present_, below_, place_below_);
    for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) {
      const Side regions = side(below_, kind);
      auto& names = names_[index(kind)];
      names.assign(regions.last, 0);  // the outside is 0 also where it has no boundary
      for (const std::uint32_t s : present_) {
        names[regions.of_link[place_below_[s]]] =
            name_of_ring_[index(kind)].at(history_.ring_of(s, group));
      }
    }
  }

  void pass(std::uint32_t group) {
    if (stale_) refresh(group);
    const Rational scale = history_.scale(group);
    const BoundaryAtGroup at_group = history_.at_group(group);
    BoundaryState at_scale = history_.at(group, at_group, present_);
    const std::vector<BoundaryLink> at_links = at_scale.links;
    const BoundaryRegions here =
        boundary_regions(history_.tracks(), std::move(at_scale), finder_, scale);
    const std::vector<std::uint32_t> before = present_;
    move_on(group);
    BoundaryRegions above = between(group + 1);
    place(present_, above, place_above_);
    change_ = changes_.at(group, at_group, before, present_);
    bool changed = false;
    for (const FeatureKind kind : {FeatureKind::hole, FeatureKind::component}) {
      const Side b = side(below_, kind), h = side(here, kind), a = side(above, kind);
      Relation relation{std::vector<std::set<std::uint32_t>>(b.last),
                        std::vector<std::set<std::uint32_t>>(a.last)};
      for (std::size_t i = 0; i < at_links.size(); ++i) {
        const std::uint32_t region = h.of_link[here.place[i]];
        if (at_links[i].before != no_sub_edge) {
          relation.at_of_before[b.of_link[place_below_[at_links[i].before]]].insert(region);
        }
        if (at_links[i].after != no_sub_edge) {
          relation.at_of_after[a.of_link[place_above_[at_links[i].after]]].insert(region);
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
    const auto first =
        std::partition_point(result_.topology.begin(), result_.topology.end(),
                             [&](const TopologyEvent& e) { return e.group < group; });
    std::sort(first, result_.topology.end(), [](const TopologyEvent& x, const TopologyEvent& y) {
      return std::tie(x.kind, x.change, x.before, x.after) <
             std::tie(y.kind, y.change, y.before, y.after);
    });
    if (changed && !change_) throw std::logic_error("holes or components change in no place");
    if (change_) boundary_event(group, above);
    below_ = std::move(above);
    place_below_.swap(place_above_);
    show_features(group + 1);
    if (change_) show_rings(group + 1);
    count(group + 1, here);
  }

  /// Finds components whose whole boundary lies inside another component at the scale: an island
  /// that fills its hole. (None shrinks to a point: it holds the sum of two triangles.)
  void find_swallowed(std::vector<std::set<std::uint32_t>>& at_of, const BoundaryRegions& regions,
                      const BoundaryRegions& here, const Rational& scale) const {
    for (std::size_t i = 0; i < regions.links.size(); ++i) {
      const std::uint32_t component = regions.component[i];
      if (!at_of[component].empty()) continue;
      const Point from = history_.tracks()[regions.links[i].from].at(scale);
      const Point to = history_.tracks()[regions.links[i].to].at(scale);
      if (from == to) continue;
      const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
      at_of[component].insert(component_around(history_.tracks(), here, middle, scale));
    }
  }

  /// Carries the names across; reports every relation that is not one to one. Returns whether it
  /// reported any.
  bool relate(FeatureKind kind, const Relation& relation, std::uint32_t at_count,
              std::uint32_t group, const Rational& scale, const BoundaryRegions& here,
              const BoundaryRegions& above) {
    auto& names = names_[index(kind)];
    const auto old = names;
    names.assign(relation.at_of_after.size(), no_entry);
    // Clusters of connected regions.
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
    std::vector<std::uint32_t> born;
    for (std::uint32_t a = 0; a < relation.at_of_after.size(); ++a) {
      if (relation.at_of_after[a].empty()) {
        born.push_back(a);
      } else {
        clusters[find(*relation.at_of_after[a].begin())].after.push_back(a);
      }
    }
    std::vector<Extent> extent;  // if several need an order
    const auto in_place = [&](std::uint32_t x, std::uint32_t y) { return extent[x] < extent[y]; };
    std::size_t fresh_names = born.size();
    for (const auto& [root, members] : clusters) {
      if (members.after.size() > 1) fresh_names += members.after.size();
    }
    if (fresh_names > 1) extent = extents(kind, above, scale);
    if (born.size() > 1) std::sort(born.begin(), born.end(), in_place);
    for (const std::uint32_t a : born) {
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
    std::vector<Members*> in_order;
    for (auto& [root, members] : clusters) in_order.push_back(&members);
    if (fresh_names > 1) {
      for (Members* const members : in_order) {
        std::sort(members->after.begin(), members->after.end(), in_place);
      }
      // Clusters that give no name come first, in any order.
      std::sort(in_order.begin(), in_order.end(), [&](const Members* x, const Members* y) {
        if (x->after.size() < 2 || y->after.size() < 2) return x->after.size() < y->after.size();
        return extent[x->after[0]] < extent[y->after[0]];
      });
    }
    for (Members* const one : in_order) {
      Members& members = *one;
      if (members.before.size() == 1 && members.after.size() == 1) {
        names[members.after[0]] = old[members.before[0]];
        if (members.at.size() == 1) continue;
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

  static bool before(const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

  std::uint32_t fresh(FeatureKind kind, std::uint32_t group) {
    features(kind).push_back({group, {}});
    return static_cast<std::uint32_t>(features(kind).size() - 1);
  }

  /// Sorts the outside first, then by area at the scale, largest first, then by index.
  void order_by_size(FeatureKind kind, std::vector<std::uint32_t>& after, const Relation& relation,
                     const BoundaryRegions& here, const Rational& scale) const {
    if (after.size() < 2) return;
    const Side regions = side(here, kind);
    std::map<std::uint32_t, Rational> doubled;
    for (std::size_t i = 0; i < here.links.size(); ++i) {
      const Point a = history_.tracks()[here.links[i].from].at(scale);
      const Point b = history_.tracks()[here.links[i].to].at(scale);
      doubled[regions.of_link[i]] += a.x * b.y - a.y * b.x;
    }
    std::map<std::uint32_t, Rational> size;
    for (const std::uint32_t a : after) {
      for (const std::uint32_t region : relation.at_of_after[a]) size[a] += abs(doubled[region]);
    }
    std::stable_sort(after.begin(), after.end(), [&](std::uint32_t x, std::uint32_t y) {
      const bool outside_x = kind == FeatureKind::hole && x == 0;
      const bool outside_y = kind == FeatureKind::hole && y == 0;
      if (outside_x != outside_y) return outside_x;
      return size[x] > size[y];
    });
  }

  /// A point that a region shrinks to, or grows from.
  Point vanishing_place(FeatureKind kind, const BoundaryRegions& regions, std::uint32_t region,
                        const Rational& scale) const {
    std::optional<Point> least;
    const Side of = side(regions, kind);
    for (std::size_t i = 0; i < regions.links.size(); ++i) {
      if (of.of_link[i] != region) continue;
      const Point p = history_.tracks()[regions.links[i].from].at(scale);
      if (!least || before(p, *least)) least = p;
    }
    return least.value_or(Point{});
  }

  /// A point where regions touch one another or themselves.
  Point pinch(FeatureKind kind, const std::vector<std::uint32_t>& regions,
              const BoundaryRegions& here, const Rational& scale) const {
    const Side of = side(here, kind);
    std::map<std::uint32_t, std::size_t> seen;
    std::optional<Point> least;
    for (std::size_t i = 0; i < here.links.size(); ++i) {
      const auto& link = here.links[i];
      if (std::find(regions.begin(), regions.end(), of.of_link[i]) == regions.end()) continue;
      if (std::find(here.pinches.begin(), here.pinches.end(), link.from) == here.pinches.end()) {
        continue;
      }
      ++seen[link.from];
    }
    for (const auto& [point, times] : seen) {
      if (times < 2) continue;
      const Point p = history_.tracks()[point].at(scale);
      if (!least || before(p, *least)) least = p;
    }
    if (least) return *least;
    if (!change_) throw std::logic_error("regions touch in no place");
    return change_->place;  // regions touch along segments
  }

  void boundary_event(std::uint32_t group, const BoundaryRegions& above) {
    using Change = BoundaryEvent::Change;
    const std::size_t old_size = below_.edges.size(), new_size = above.edges.size();
    const Change change = below_.edges == above.edges ? Change::touch
                          : new_size > old_size       ? Change::birth
                          : new_size < old_size       ? Change::death
                                                      : Change::swap;
    result_.boundary.push_back({group, change, change_->edges, change_->place});
  }

  const BoundaryHistory& history_;
  const std::function<void(RingsFrom)>& show_rings_;
  const std::function<void(FeaturesFrom)>& show_features_;
  CycleFinder finder_;
  BoundaryChanges changes_;
  std::vector<std::uint32_t> present_;  ///< sub-edges
  BoundaryRegions below_;
  std::vector<std::uint32_t> place_below_, place_above_;  ///< of sub-edges, among the links
  std::array<std::vector<std::uint32_t>, 2> names_;       ///< feature of each region, by kind
  std::optional<BoundaryChange> change_;                  ///< at the group that is being passed
  bool stale_ = false;  ///< below_ is from before groups that were skipped
  std::array<std::unordered_map<std::uint32_t, std::uint32_t>, 2> name_of_ring_;
  TopologyTimeline result_;
};

}  // namespace

TopologyTimeline topology_timeline(const BoundaryHistory& history,
                                   const std::function<void(RingsFrom)>& rings,
                                   const std::function<void(FeaturesFrom)>& features) {
  const FloatEnvironment standard;
  return TimelineBuilder(history, rings, features).build();
}

}  // namespace minkref::inline plane
