#include "reference/space/surface/near_things.hpp"

#include <algorithm>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/near/near_pairs.hpp"
#include "reference/space/edges/near_points.hpp"

namespace minkref::inline space {
namespace {

/// For each thing: boxes do not help beyond so many pairs.
constexpr std::size_t most_box_pairs = 48;

}  // namespace

void NearThings::add(std::vector<std::uint32_t> corners) {
  SpaceBox box;
  for (const std::uint32_t c : corners) box.add(box_between(points_[c], points_[c]));
  boxes_.push_back(box);
  corners_.push_back(std::move(corners));
}

bool NearThings::has_corner(std::uint32_t thing, std::uint32_t point) const {
  const std::vector<std::uint32_t>& corners = corners_[thing];
  return has_few(thing) && std::find(corners.begin(), corners.end(), point) != corners.end();
}

void NearThings::pairs(const Report& report, std::uint32_t first) const {
  const Report wanted = [&](std::uint32_t i, std::uint32_t j) {
    if (first == 0 || (i < first && j >= first)) report(i, j);
  };
  if (pairs_by_boxes(wanted, first)) return;
  pairs_by_clusters(wanted);
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (has_few(i)) continue;
    for (std::uint32_t j = 0; j < corners_.size(); ++j) {
      look_for_interrupt();
      const bool again = j <= i && !has_few(j);
      if (!again && boxes_[i].overlaps(boxes_[j])) wanted(std::min(i, j), std::max(i, j));
    }
  }
}

/// Returns false, with an unfinished list, once there are too many pairs.
bool NearThings::pairs_by_boxes(const Report& report, std::uint32_t first) const {
  std::size_t left = most_box_pairs * corners_.size();
  const auto count = [&](std::uint32_t i, std::uint32_t j) {
    look_for_interrupt();
    // Large things are left to boxes anyway.
    if (has_few(i) && has_few(j) && left-- == 0) return true;
    report(std::min(i, j), std::max(i, j));
    return false;
  };
  if (first == 0) return !SpaceBoxTree(boxes_).pairs(count);
  const SpaceBoxTree before({boxes_.begin(), boxes_.begin() + first});
  for (std::uint32_t j = first; j < boxes_.size(); ++j) {
    if (before.query(boxes_[j], [&](std::uint32_t i) { return count(i, j); })) return false;
  }
  return true;
}

/// Pairs with few corners each. Triangles from a corner cover a polygon, convex or not.
void NearThings::pairs_by_clusters(const Report& report) const {
  std::vector<NearItem> items;
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const std::vector<std::uint32_t>& c = corners_[i];
    if (!has_few(i)) continue;
    if (c.size() == 2) items.push_back({{c[0], c[1], c[1]}, i});
    for (std::size_t k = 2; k < c.size(); ++k) items.push_back({{c[0], c[k - 1], c[k]}, i});
  }
  std::vector<BoundedVector> bounded;
  bounded.reserve(points_.size());
  for (const SpaceVertex& p : points_) bounded.push_back(p.rounded);
  std::vector<std::uint32_t> thing;
  thing.reserve(items.size());
  for (const NearItem& item : items) thing.push_back(item.group);
  NearPairs(near_points(bounded), std::move(items)).pairs([&](std::uint32_t a, std::uint32_t b) {
    report(thing[a], thing[b]);
  });
}

}  // namespace minkref::inline space
