#include "reference/disc/clearance/level_ways.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline disc {

LevelWays::LevelWays(const std::vector<Numbers>& joined,
                     const std::function<std::uint32_t(std::uint32_t)>& level)
    : joined_(joined), levels_(joined.size()) {
  for (std::uint32_t node = 0; node < levels_.size(); ++node) levels_[node] = level(node);
}

LevelWays::Found LevelWays::find(std::uint32_t start, std::uint32_t end) const {
  const auto count = static_cast<std::uint32_t>(levels_.size());
  Numbers order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return levels_[a] != levels_[b] ? levels_[a] > levels_[b] : a < b;
  });
  DisjointSets together(count);
  for (std::uint32_t first = 0; first < count;) {
    look_for_interrupt();
    const std::uint32_t level = levels_[order[first]];
    Numbers nodes;
    for (; first < count && levels_[order[first]] == level; ++first) nodes.push_back(order[first]);
    std::vector<Numbers> parts;  // above the level, next to each node
    for (const std::uint32_t node : nodes) {
      Numbers& own = parts.emplace_back();
      for (const std::uint32_t other : joined_[node]) {
        if (levels_[other] > level) own.push_back(together.root(other));
      }
    }
    const std::uint32_t from = together.root(start), to = together.root(end);
    for (const std::uint32_t node : nodes) {
      for (const std::uint32_t other : joined_[node]) {
        if (levels_[other] >= level) together.join(node, other);
      }
    }
    if (levels_[start] < level || levels_[end] < level) continue;
    if (together.root(start) != together.root(end)) continue;
    const bool is_above = levels_[start] > level && levels_[end] > level;
    return {true, level, is_above ? doors_between(nodes, parts, from, to) : Numbers{}};
  }
  return {};
}

LevelWays::Numbers LevelWays::doors_between(const Numbers& nodes, const std::vector<Numbers>& parts,
                                            std::uint32_t from, std::uint32_t to) const {
  std::map<std::uint32_t, std::uint32_t> place;  // by node
  for (std::uint32_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = k;
  DisjointSets doors(nodes.size());
  for (const std::uint32_t node : nodes) {
    for (const std::uint32_t other : joined_[node]) {
      if (const auto found = place.find(other); found != place.end()) {
        doors.join(place[node], found->second);
      }
    }
  }
  std::map<std::uint32_t, Numbers> of_part, of_door;  // places of nodes
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    of_door[doors.root(k)].push_back(k);
    for (const std::uint32_t part : parts[k]) of_part[part].push_back(k);
  }
  struct Step {
    std::uint32_t part, node;  ///< from which part, by which node into the door
  };
  std::map<std::uint32_t, Step> came;  // by part
  std::map<std::uint32_t, bool> passed;
  came[from] = {from, 0};
  for (Numbers next{from}; !next.empty() && !came.contains(to);) {
    Numbers beyond;
    for (const std::uint32_t part : next) {
      for (const std::uint32_t entrance : of_part[part]) {
        bool& is_passed = passed[doors.root(entrance)];
        if (is_passed) continue;
        is_passed = true;
        for (const std::uint32_t exit : of_door[doors.root(entrance)]) {
          for (const std::uint32_t other : parts[exit]) {
            if (!came.emplace(other, Step{part, nodes[entrance]}).second) continue;
            beyond.push_back(other);
          }
        }
      }
    }
    next = std::move(beyond);
  }
  Numbers found;
  for (std::uint32_t part = to; part != from; part = came.at(part).part) {
    found.push_back(came.at(part).node);
  }
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace minkref::inline disc
