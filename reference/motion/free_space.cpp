#include "reference/motion/free_space.hpp"

#include <algorithm>
#include <numeric>

#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
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

/// An edge of a cell's boundary or of a passage; a passage of one point has both ends there.
struct OwnedEdge {
  FilteredPoint from, to;
  std::size_t owner;  ///< cells, then passages
};

bool is_on(const OwnedEdge& edge, const FilteredPoint& x) {
  int winding = 0;
  return add_winding(edge.from, edge.to, x, winding);
}

Box box_of(const OwnedEdge& edge) {
  Box box;
  for (const FilteredPoint* p : {&edge.from, &edge.to}) {
    box.add({below(p->x()), below(p->y()), above(p->x()), above(p->y())});
  }
  return box;
}

void add_chain(std::vector<OwnedEdge>& edges, const FilteredRing& points, std::size_t owner) {
  if (points.size() == 1) edges.push_back({points[0], points[0], owner});
  for (std::size_t i = 1; i < points.size(); ++i) {
    edges.push_back({points[i - 1], points[i], owner});
  }
}

void add_ring(std::vector<OwnedEdge>& edges, const FilteredRing& ring, std::size_t owner) {
  add_chain(edges, ring, owner);
  edges.push_back({ring.back(), ring.front(), owner});
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

bool FreeSpace::on_passage(const TightPassage& passage, const Point& x) {
  const auto& points = passage.points;
  if (points.size() == 1) return points[0] == x;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (is_on(points[i], points[i + 1], x)) return true;
  }
  return false;
}

/// Joins cells and passages with a common point: a vertex of either lies on an edge of the other.
void FreeSpace::join_touching() {
  const FloatEnvironment standard;
  std::vector<OwnedEdge> edges;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    for (const Polygon& polygon : cells_[k].polygons) {
      add_ring(edges, filtered_ring(polygon.outer), k);
      for (const Ring& hole : polygon.holes) add_ring(edges, filtered_ring(hole), k);
    }
  }
  for (std::size_t k = 0; k < passages_.size(); ++k) {
    add_chain(edges, filtered_ring(passages_[k].points), cells_.size() + k);
  }
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const OwnedEdge& edge : edges) boxes.push_back(box_of(edge));
  const BoxTree tree(std::move(boxes));
  for (const OwnedEdge& edge : edges) {
    for (const FilteredPoint* x : {&edge.from, &edge.to}) {
      tree.query(box_of({*x, *x, edge.owner}), [&](std::uint32_t other) {
        const std::size_t a = root(edge.owner), b = root(edges[other].owner);
        if (a != b && is_on(edges[other], *x)) joined_[std::max(a, b)] = std::min(a, b);
        return false;
      });
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
