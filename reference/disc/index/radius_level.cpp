#include "reference/disc/index/radius_level.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace minkref::inline disc {

std::vector<RadiusLevel::Group> RadiusLevel::groups() const {
  DisjointSets together = doors_;
  std::map<std::uint32_t, std::uint32_t> first_node;  // by part
  for (const auto& [node, part] : ways_) {
    const auto [found, is_new] = first_node.try_emplace(part, node);
    if (!is_new) together.join(node, found->second);
  }
  std::vector<Group> groups;
  std::map<std::uint32_t, std::size_t> number;  // by root
  const auto group_of = [&](std::uint32_t node) -> Group& {
    const auto [found, is_new] = number.try_emplace(together.root(node), groups.size());
    if (is_new) groups.emplace_back();
    return groups[found->second];
  };
  for (std::uint32_t node = 0; node < doors_.size(); ++node) group_of(node).nodes.push_back(node);
  for (const auto& way : ways_) group_of(way.first).ways.push_back(way);
  for (const auto& [part, node] : first_node) group_of(node).parts.push_back(part);
  return groups;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> RadiusLevel::cut_off(
    const Group& group, std::uint32_t from) const {
  DisjointSets doors = doors_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> doors_of;  // by part
  std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> ways_of;
  for (const auto& [node, part] : group.ways) {
    doors_of[part].push_back(doors.root(node));
    ways_of[doors.root(node)].emplace_back(node, part);
  }
  std::set<std::uint32_t> passed;  // doors
  std::map<std::uint32_t, std::uint32_t> known{{from, 0}};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::vector<std::uint32_t> next{from}; !next.empty();) {
    std::map<std::uint32_t, std::uint32_t> beyond;  // of parts the first node
    for (const std::uint32_t part : next) {
      for (const std::uint32_t door : doors_of[part]) {
        if (!passed.insert(door).second) continue;
        for (const auto& [node, other] : ways_of[door]) {
          if (known.contains(other)) continue;
          const auto [first, is_new] = beyond.try_emplace(other, node);
          if (!is_new) first->second = std::min(first->second, node);
        }
      }
    }
    next.clear();
    for (const auto& way : beyond) {
      known.insert(way);
      found.push_back(way);
      next.push_back(way.first);
    }
  }
  return found;
}

}  // namespace minkref::inline disc
