#include "reference/plane/decomposition/wall_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace minkref::inline plane {
namespace {

Box box_of(const FilteredPoint& p) {
  return {below(p.x()), below(p.y()), above(p.x()), above(p.y())};
}

Box widened(const Box& box, double by) {
  return {below(box.xmin - by), below(box.ymin - by), above(box.xmax + by), above(box.ymax + by)};
}

bool holds(const Box& outer, const Box& inner) {
  return outer.xmin <= inner.xmin && outer.ymin <= inner.ymin && outer.xmax >= inner.xmax &&
         outer.ymax >= inner.ymax;
}

double length(const FilteredPoint& a, const FilteredPoint& b) {
  return std::hypot(b.x() - a.x(), b.y() - a.y());
}

constexpr std::size_t few = 64;
constexpr std::uint32_t no_wall = 0xffffffffU;

}  // namespace

void WallSearch::add(FilteredPoint from, FilteredPoint to) {
  Box box = box_of(from);
  box.add(box_of(to));
  all_.add(box);
  walls_.push_back({std::move(from), std::move(to), box});
  if (walls_.size() < few + tree_.size() + tree_.size() / 4) return;
  std::vector<Box> boxes;
  boxes.reserve(walls_.size());
  for (const Wall& wall : walls_) boxes.push_back(wall.box);
  tree_ = BoxTree(std::move(boxes));
}

void WallSearch::collect(const Box& about, const ResolvingCone& cone,
                         std::vector<Candidate>& found) const {
  const FilteredPoint& apex = cone.apex();
  const auto take = [&](std::uint32_t number) {
    look_for_interrupt();
    const Wall& wall = walls_[number];
    if (compare_xy(wall.from, apex) == 0 || compare_xy(wall.to, apex) == 0) return false;
    const double bound = cone.squared_bound(wall.from, wall.to);
    if (bound < std::numeric_limits<double>::infinity()) found.push_back({bound, number});
    return false;
  };
  tree_.query(about, take);
  for (std::size_t wall = tree_.size(); wall < walls_.size(); ++wall) {
    if (walls_[wall].box.overlaps(about)) take(static_cast<std::uint32_t>(wall));
  }
  std::ranges::sort(found, [](const Candidate& a, const Candidate& b) {
    return a.squared_bound != b.squared_bound ? a.squared_bound < b.squared_bound : a.wall < b.wall;
  });
}

void WallSearch::improve(const ResolvingCone& cone, std::uint32_t number, Hit& best) const {
  const Wall& wall = walls_[number];
  const Point& apex = cone.apex().exact();
  const std::optional<Point> at = cone.nearest(wall.from, wall.to);
  if (!at) return;
  const Rational dx = at->x - apex.x, dy = at->y - apex.y;
  Hit hit{*at, dx * dx + dy * dy, number};
  if (best.wall != no_wall) {
    if (hit.squared_length > best.squared_length) return;
    if (hit.squared_length == best.squared_length) {
      const int order = compare_xy(hit.at, best.at);
      if (order > 0 || (order == 0 && hit.wall > best.wall)) return;
    }
  }
  best = std::move(hit);
}

WallSearch::Hit WallSearch::nearest(const ResolvingCone& cone) const {
  const Box apex = box_of(cone.apex());
  const double extent = std::hypot(all_.xmax - all_.xmin, all_.ymax - all_.ymin);
  double reach = std::min({length(cone.apex(), cone.first()), length(cone.apex(), cone.second()),
                           extent / std::sqrt(static_cast<double>(walls_.size()))});
  if (!(reach > 0)) reach = extent;
  std::vector<Candidate> candidates;
  for (;; reach *= 2) {
    look_for_interrupt();
    const Box about = widened(apex, reach);
    candidates.clear();
    collect(about, cone, candidates);
    Hit best;
    best.wall = no_wall;
    double bound = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates) {
      look_for_interrupt();
      if (candidate.squared_bound > bound) break;
      improve(cone, candidate.wall, best);
      if (best.wall != no_wall) bound = above(to_double(best.squared_length));
    }
    // Walls that miss the box are further away than `reach`.
    const bool has_all = holds(about, all_);
    if (best.wall != no_wall && (has_all || bound <= below(reach * reach))) return best;
    if (has_all) throw std::logic_error("decomposition: no wall meets a notch's cone");
  }
}

}  // namespace minkref::inline plane
