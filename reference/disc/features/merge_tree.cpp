#include "reference/disc/features/merge_tree.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

using Numbers = std::vector<std::uint32_t>;

class TreeSearch {
 public:
  explicit TreeSearch(const DiscIndex& index)
      : index_(index),
        graph_(index.graph()),
        count_(graph_.events + graph_.gaps + graph_.reflex_vertices),
        together_(count_),
        flat_(count_),
        feature_(count_, MergeTree::none),
        leaving_(count_) {
    for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
      leaving_[graph_.halves[k].from].push_back(k);
    }
    tree_.feature_of.resize(count_);
  }

  MergeTree find() {
    const auto events = static_cast<std::uint32_t>(graph_.events),
               after_gaps = static_cast<std::uint32_t>(events + graph_.gaps);
    for (std::uint32_t node = after_gaps; node < count_; ++node) {
      put_feature({node}, new_node(MergeNode::Kind::reflex, 0, {{node}}, {}));
    }
    for (std::uint32_t first = 0; first < events;) {
      std::uint32_t last = first;
      while (last < events && radius(last) == radius(first)) ++last;
      add_level(first, last);
      first = last;
    }
    if (graph_.gaps > 0) add_infinity(events, after_gaps);
    add_holes();
    sort_nodes();
    return std::move(tree_);
  }

 private:
  std::uint32_t radius(std::uint32_t node) const { return index_.radius_number(node); }

  std::uint32_t new_node(MergeNode::Kind kind, std::uint32_t radius, std::vector<Numbers> places,
                         const std::set<std::uint32_t>& children) {
    const auto number = static_cast<std::uint32_t>(tree_.nodes.size());
    for (const std::uint32_t child : children) tree_.nodes[child].parent = number;
    tree_.nodes.push_back({kind, radius, std::move(places),
                           Numbers(children.begin(), children.end()), MergeTree::none});
    return number;
  }

  void put_feature(const Numbers& nodes, std::uint32_t feature) {
    for (const std::uint32_t node : nodes) tree_.feature_of[node] = feature;
    feature_[together_.root(nodes.front())] = feature;
  }

  /// The features below a node, found before the node is joined to them.
  void look_below(std::uint32_t node, std::set<std::uint32_t>& found) {
    for (const std::uint32_t half : leaving_[node]) {
      const std::uint32_t other = graph_.halves[half].to;
      if (radius(other) < radius(node)) found.insert(feature_[together_.root(other)]);
    }
  }

  /// Adds the events of one radius, last excluded.
  void add_level(std::uint32_t first, std::uint32_t last) {
    std::vector<std::set<std::uint32_t>> below(last - first);
    for (std::uint32_t node = first; node < last; ++node) {
      look_for_interrupt();
      look_below(node, below[node - first]);
    }
    for (std::uint32_t node = first; node < last; ++node) {
      for (const std::uint32_t half : leaving_[node]) {
        const std::uint32_t other = graph_.halves[half].to;
        if (radius(other) == radius(node)) flat_.join(node, other);
        if (radius(other) <= radius(node)) together_.join(node, other);
      }
    }
    struct Group {
      Numbers nodes;
      std::set<std::uint32_t> below;
    };
    std::map<std::uint32_t, std::map<std::uint32_t, Group>> connected;  // by roots
    for (std::uint32_t node = first; node < last; ++node) {
      Group& group = connected[together_.root(node)][flat_.root(node)];
      group.nodes.push_back(node);
      group.below.merge(below[node - first]);
    }
    for (const auto& [root, groups] : connected) {
      Numbers nodes;
      std::vector<Numbers> places;
      std::set<std::uint32_t> features;
      for (const auto& [flat, group] : groups) {
        nodes.insert(nodes.end(), group.nodes.begin(), group.nodes.end());
        features.insert(group.below.begin(), group.below.end());
        if (group.below.size() != 1) places.push_back(group.nodes);
      }
      std::uint32_t feature = features.empty() ? MergeTree::none : *features.begin();
      if (features.size() != 1) {
        std::sort(places.begin(), places.end());
        feature = new_node(features.empty() ? MergeNode::Kind::minimum : MergeNode::Kind::merge,
                           radius(first), std::move(places), features);
      }
      put_feature(nodes, feature);
    }
  }

  void add_infinity(std::uint32_t first, std::uint32_t last) {
    std::set<std::uint32_t> below;
    std::vector<Numbers> places;
    Numbers nodes;
    for (std::uint32_t node = first; node < last; ++node) {
      look_below(node, below);
      places.push_back({node});
      nodes.push_back(node);
    }
    for (const std::uint32_t node : nodes) {
      together_.join(node, first);
      for (const std::uint32_t half : leaving_[node]) {
        together_.join(node, graph_.halves[half].to);
      }
    }
    put_feature(nodes, new_node(MergeNode::Kind::outside, radius(first), std::move(places), below));
  }

  /// A root for each component without infinity.
  void add_holes() {
    std::map<std::uint32_t, std::uint32_t> greatest;  // radii, by component
    for (std::uint32_t node = 0; node < graph_.events; ++node) {
      greatest[together_.root(node)] = radius(node);  // they ascend
    }
    if (graph_.gaps > 0) greatest.erase(together_.root(static_cast<std::uint32_t>(graph_.events)));
    std::map<std::uint32_t, std::map<std::uint32_t, Numbers>> ridges;
    for (std::uint32_t node = 0; node < graph_.events; ++node) {
      const auto found = greatest.find(together_.root(node));
      if (found == greatest.end() || found->second != radius(node)) continue;
      ridges[found->first][flat_.root(node)].push_back(node);
    }
    for (auto& [root, groups] : ridges) {
      std::vector<Numbers> places;
      for (auto& [flat, nodes] : groups) places.push_back(std::move(nodes));
      std::sort(places.begin(), places.end());
      new_node(MergeNode::Kind::hole, greatest[root], std::move(places), {feature_[root]});
    }
  }

  ReflexEnd reflex_end(std::uint32_t node) const {
    const DiagramHalf& half = graph_.halves[leaving_[node].front()];
    const DiagramEvents& diagram = index_.diagram();
    const BoundarySide& side = diagram.walks.sides[half.from_side];
    return {diagram.curves.features[side.from].centre,
            primitive(diagram.curves.edges[side.edge].along)};
  }

  void sort_nodes() {
    std::vector<MergeNode>& nodes = tree_.nodes;
    std::vector<ReflexEnd> ends;
    for (std::size_t k = 0; k < graph_.reflex_vertices; ++k) {
      ends.push_back(reflex_end(nodes[k].places[0][0]));
    }
    const auto end_order = [&](std::uint32_t k) {
      const ReflexEnd& end = ends[k];
      return std::tie(end.vertex.x, end.vertex.y, end.along.x, end.along.y);
    };
    const auto order = [&](std::uint32_t k) {
      const bool is_root = nodes[k].kind >= MergeNode::Kind::hole;
      return std::tuple(nodes[k].radius, is_root, nodes[k].places[0][0]);
    };
    Numbers sorted(nodes.size()), number(nodes.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    const auto first_inner = sorted.begin() + static_cast<std::ptrdiff_t>(ends.size());
    std::sort(sorted.begin(), first_inner,
              [&](auto a, auto b) { return end_order(a) < end_order(b); });
    std::sort(first_inner, sorted.end(), [&](auto a, auto b) { return order(a) < order(b); });
    std::vector<MergeNode> in_order;
    for (std::uint32_t k = 0; k < sorted.size(); ++k) number[sorted[k]] = k;
    for (const std::uint32_t k : sorted) {
      in_order.push_back(std::move(nodes[k]));
      MergeNode& node = in_order.back();
      if (node.parent != MergeTree::none) node.parent = number[node.parent];
      for (std::uint32_t& child : node.children) child = number[child];
      std::sort(node.children.begin(), node.children.end());
      if (k < ends.size()) tree_.ends.push_back(std::move(ends[k]));
    }
    nodes = std::move(in_order);
    tree_.rising.resize(nodes.size());
    for (std::uint32_t node = 0; node < count_; ++node) {
      std::uint32_t& feature = tree_.feature_of[node];
      feature = number[feature];
      for (const std::uint32_t half : leaving_[node]) {
        if (radius(graph_.halves[half].to) > radius(node)) tree_.rising[feature].push_back(half);
      }
    }
  }

  const DiscIndex& index_;
  const DiagramGraph& graph_;
  std::uint32_t count_;
  DisjointSets together_;  ///< nodes, by component below the present level
  DisjointSets flat_;      ///< nodes, by flat ridge
  Numbers feature_;        ///< by component
  std::vector<Numbers> leaving_;
  MergeTree tree_;
};

}  // namespace

MergeTree merge_tree(const DiscIndex& index) { return TreeSearch(index).find(); }

}  // namespace minkref::inline disc
