#include "reference/plane/history/boundary_history.hpp"

#include <algorithm>

namespace minkref::inline plane {
namespace {

const std::vector<std::uint32_t> nothing;

}  // namespace

std::uint32_t BoundaryAtGroup::standing_for(std::uint32_t track) const {
  const auto found = std::lower_bound(merged.begin(), merged.end(), std::pair(track, 0U));
  return found != merged.end() && found->first == track ? found->second : track;
}

bool BoundaryAtGroup::is_interrupted(std::uint32_t sub_edge) const {
  return std::binary_search(interrupted.begin(), interrupted.end(), sub_edge);
}

void BoundaryHistory::sort_by_interval() {
  const std::vector<MovingLink>& all = sub_edges();
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    begin_[all[k].first].push_back(k);
    end_[all[k].last].push_back(k);
  }
}

std::vector<std::uint32_t> BoundaryHistory::sub_edges_in(std::uint32_t interval) const {
  const std::vector<MovingLink>& all = sub_edges();
  std::vector<std::uint32_t> result;
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    if (all[k].first <= interval && interval <= all[k].last) result.push_back(k);
  }
  return result;
}

const std::vector<std::uint32_t>& BoundaryHistory::begin_with(std::uint32_t interval) const {
  const auto found = begin_.find(interval);
  return found == begin_.end() ? nothing : found->second;
}
const std::vector<std::uint32_t>& BoundaryHistory::end_with(std::uint32_t interval) const {
  const auto found = end_.find(interval);
  return found == end_.end() ? nothing : found->second;
}

BoundaryState BoundaryHistory::between(const std::vector<std::uint32_t>& present) const {
  BoundaryState state;
  for (const std::uint32_t k : present) {
    const MovingLink& link = sub_edges()[k];
    state.links.push_back({link.from, link.to, link.edge, k, k});
  }
  return state;
}

BoundaryState BoundaryHistory::at(std::uint32_t group, const BoundaryAtGroup& here,
                                  const std::vector<std::uint32_t>& present) const {
  BoundaryState state;
  for (const std::uint32_t k : present) {
    const MovingLink& link = sub_edges()[k];
    if (link.last <= group || here.is_interrupted(k)) continue;
    state.links.push_back(
        {here.standing_for(link.from), here.standing_for(link.to), link.edge, k, k});
  }
  state.links.insert(state.links.end(), here.pieces.begin(), here.pieces.end());
  return state;
}

}  // namespace minkref::inline plane
