#include "reference/disc/features/barcode.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/disc/features/leaf_depth.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

class BarSearch {
 public:
  BarSearch(const Bridges& bridges, const MergeTree& tree)
      : bridges_(bridges), tree_(tree), open_(tree.rising) {
    codes_.elder.resize(tree.nodes.size());
    codes_.bar_of.resize(tree.nodes.size());
    codes_.is_tie.resize(tree.nodes.size(), 0);
  }

  Barcode find() {
    for (std::uint32_t node = 0; node < tree_.nodes.size(); ++node) {
      look_for_interrupt();
      if (tree_.is_leaf(node)) {
        codes_.elder[node] = node;
        codes_.bar_of[node] = static_cast<std::uint32_t>(codes_.bars.size());
        codes_.bars.push_back({node, tree_.nodes[node].radius, 0, MergeTree::none, false, false});
      } else {
        merge(node);
      }
    }
    for (std::uint32_t node = 0; node < tree_.nodes.size(); ++node) {
      codes_.bar_of[node] = codes_.bar_of[codes_.elder[node]];
    }
    return std::move(codes_);
  }

 private:
  FeatureBar& bar(std::uint32_t child) { return codes_.bars[codes_.bar_of[codes_.elder[child]]]; }

  void merge(std::uint32_t node) {
    const MergeNode& own = tree_.nodes[node];
    const std::vector<std::uint32_t> best = oldest_and_deepest(own);
    const std::uint32_t lives_on = *std::min_element(best.begin(), best.end(), [&](auto a, auto b) {
      return codes_.elder[a] < codes_.elder[b];
    });
    if (best.size() > 1) {
      codes_.is_tie[node] = 1;
      for (const std::uint32_t child : best) bar(child).is_tie = true;
    }
    const bool is_root = own.parent == MergeTree::none;
    for (const std::uint32_t child : own.children) {
      if (child != lives_on || is_root) {
        bar(child).death = own.radius;
        bar(child).end = node;
        bar(child).is_essential = child == lives_on;
      }
      add_open(node, child);
    }
    codes_.elder[node] = codes_.elder[lives_on];
  }

  /// The children between which only places decide.
  std::vector<std::uint32_t> oldest_and_deepest(const MergeNode& node) {
    std::vector<std::uint32_t> best;
    for (const std::uint32_t child : node.children) {
      const std::uint32_t birth = bar(child).birth;
      if (!best.empty() && birth > bar(best[0]).birth) continue;
      if (!best.empty() && birth < bar(best[0]).birth) best.clear();
      best.push_back(child);
    }
    if (best.size() == 1 || !tree_.is_reflex(codes_.elder[best[0]])) return best;
    const BridgeRadius& radius = radius_of(node.radius);
    std::vector<std::pair<LeafDepth, std::uint32_t>> deepest;
    for (const std::uint32_t child : best) {
      std::vector<std::uint32_t>& open = open_[child];
      std::erase_if(open, [&](auto half) { return bridges_.index().high(half) < node.radius; });
      LeafDepth depth(bridges_, tree_.ends[codes_.elder[child]].vertex, open, radius);
      const int order = deepest.empty() ? 0 : compare(depth, deepest[0].first);
      if (order < 0) continue;
      if (order > 0) deepest.clear();
      deepest.emplace_back(std::move(depth), child);
    }
    best.clear();
    for (const auto& [depth, child] : deepest) best.push_back(child);
    return best;
  }

  const BridgeRadius& radius_of(std::uint32_t number) {
    if (!radius_ || radius_->number != number) radius_ = bridges_.of_events(number);
    return *radius_;
  }

  void add_open(std::uint32_t node, std::uint32_t child) {
    std::vector<std::uint32_t>&own = open_[node], &more = open_[child];
    if (own.size() < more.size()) std::swap(own, more);
    own.insert(own.end(), more.begin(), more.end());
    more = {};
  }

  const Bridges& bridges_;
  const MergeTree& tree_;
  /// Halves rising from each tree node's feature, all leaving halves among them.
  std::vector<std::vector<std::uint32_t>> open_;
  std::optional<BridgeRadius> radius_;
  Barcode codes_;
};

}  // namespace

Barcode barcode(const Bridges& bridges, const MergeTree& tree) {
  return BarSearch(bridges, tree).find();
}

}  // namespace minkref::inline disc
