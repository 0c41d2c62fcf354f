#include "reference/motion/free_space.hpp"

#include <algorithm>
#include <numeric>

#include "reference/interrupt.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline motion {
namespace {

bool is_on(const Point& a, const Point& b, const Point& x) {
  const Point u{a.x - x.x, a.y - x.y}, v{b.x - x.x, b.y - x.y};
  return u.x * v.y == u.y * v.x && u.x * v.x + u.y * v.y <= 0;
}

std::vector<Point> vertices_of(const PolygonSet& set) {
  std::vector<Point> all;
  for (const Polygon& polygon : set.polygons) {
    all.insert(all.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes) all.insert(all.end(), hole.begin(), hole.end());
  }
  return all;
}

Ring backwards(const Ring& ring) { return {ring.rbegin(), ring.rend()}; }

}  // namespace

FreeSpace::FreeSpace(const Sum& sum, ContactRule rule, const std::vector<Point>& about)
    : rule_(rule) {
  std::vector<Point> points = vertices_of(sum.region);
  points.insert(points.end(), about.begin(), about.end());
  Point low, high;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Ring box{{low.x - 1, low.y - 1},
                 {high.x + 1, low.y - 1},
                 {high.x + 1, high.y + 1},
                 {low.x - 1, high.y + 1}};
  PolygonSet complement{{{box, {}}}};
  for (const Polygon& polygon : sum.region.polygons) {
    complement.polygons[0].holes.push_back(backwards(polygon.outer));
    for (const Ring& hole : polygon.holes) complement.polygons.push_back({backwards(hole), {}});
  }
  for (Polygon& cell : canonicalize(complement).region.polygons) {
    const bool is_outside = cell.outer[0] == box[0];
    cells_.insert(is_outside ? cells_.begin() : cells_.end(), PolygonSet{{std::move(cell)}});
  }
  if (rule == ContactRule::allowed && sum.tight_passages) passages_ = *sum.tight_passages;
  joined_.resize(cells_.size() + passages_.size());
  std::iota(joined_.begin(), joined_.end(), std::size_t{0});
  if (rule == ContactRule::allowed) join_touching();
  number_.assign(joined_.size(), 0);
  for (std::size_t k = 0; k < joined_.size(); ++k) {
    if (root(k) == k) number_[k] = parts_++;  // the root of the outside is 0
  }
}

std::size_t FreeSpace::root(std::size_t k) const {
  while (joined_[k] != k) k = joined_[k];
  return k;
}

bool FreeSpace::on_boundary(std::size_t cell, const Point& x) const {
  return locate(cells_[cell], x) == Location::boundary;
}

bool FreeSpace::on_passage(const TightPassage& passage, const Point& x) {
  const auto& points = passage.points;
  if (points.size() == 1) return points[0] == x;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (is_on(points[i], points[i + 1], x)) return true;
  }
  return false;
}

/// Joins cells and passages with a common point: a vertex of either lies on the other.
void FreeSpace::join_touching() {
  const std::size_t cells = cells_.size();
  const auto holds = [&](std::size_t k, const Point& x) {
    return k < cells ? on_boundary(k, x) : on_passage(passages_[k - cells], x);
  };
  for (std::size_t k = 0; k < joined_.size(); ++k) {
    const std::vector<Point> own = k < cells ? vertices_of(cells_[k]) : passages_[k - cells].points;
    for (std::size_t other = 0; other < joined_.size(); ++other) {
      look_for_interrupt();
      if (root(k) == root(other)) continue;
      const bool touch =
          std::any_of(own.begin(), own.end(), [&](const Point& x) { return holds(other, x); });
      const std::size_t a = root(k), b = root(other);
      if (touch) joined_[std::max(a, b)] = std::min(a, b);
    }
  }
}

std::optional<std::size_t> FreeSpace::part_of(const Point& x) const {
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Location where = locate(cells_[k], x);
    if (where == Location::inside ||
        (where == Location::boundary && rule_ == ContactRule::allowed)) {
      return number_[root(k)];
    }
  }
  for (std::size_t k = 0; k < passages_.size(); ++k) {
    if (on_passage(passages_[k], x)) return number_[root(cells_.size() + k)];
  }
  return std::nullopt;
}

}  // namespace minkref::inline motion
