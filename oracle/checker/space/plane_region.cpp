#include "oracle/checker/space/plane_region.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "oracle/checker/json_value.hpp"

namespace minkref::checker {
namespace {

/// A directed side, and the number of the polygon to its left.
struct TileSide {
  PlanePoint from, to;
  std::size_t tile;
};

/// Upright or not, and then x, or the slope and the height at x = 0.
using PlaneLine = std::tuple<bool, mpq_class, mpq_class>;

PlaneLine line_of(const PlanePoint& a, const PlanePoint& b) {
  if (a.first == b.first) return {true, a.first, 0};
  const mpq_class slope = (b.second - a.second) / (b.first - a.first);
  return {false, slope, mpq_class(a.second - slope * a.first)};
}

bool is_on(const PlanePoint& p, const PlaneLine& line) {
  const auto& [upright, first, second] = line;
  return upright ? p.first == first : p.second == mpq_class(first * p.first + second);
}

PlanePoint way(const PlanePoint& a, const PlanePoint& b) {
  return {mpq_class(b.first - a.first), mpq_class(b.second - a.second)};
}

int turned(const PlanePoint& u, const PlanePoint& v) {
  return cmp(mpq_class(u.first * v.second), mpq_class(u.second * v.first));
}

class Classes {
 public:
  explicit Classes(std::size_t count) : root_(count) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { root_[of(i)] = of(j); }

 private:
  std::vector<std::size_t> root_;
};

/// Returns the sides without a polygon to their right, and joins polygons along the other sides.
std::vector<TileSide> outer_sides(const std::vector<PlaneRing>& tiles, Classes& parts,
                                  Budget& budget) {
  std::map<PlaneLine, std::vector<TileSide>> lines;
  for (std::size_t n = 0; n < tiles.size(); ++n) {
    for (std::size_t k = 0; k < tiles[n].size(); ++k) {
      const PlanePoint &a = tiles[n][k], &b = tiles[n][(k + 1) % tiles[n].size()];
      lines[line_of(a, b)].push_back({a, b, n});
    }
  }
  std::vector<TileSide> sides;
  for (const auto& [line, edges] : lines) {
    std::set<PlanePoint> ends;
    for (const TileSide& edge : edges) {
      ends.insert(edge.from);
      ends.insert(edge.to);
    }
    budget.spend(ends.size() * edges.size());
    const std::vector<PlanePoint> stops(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const PlanePoint &low = stops[k], &high = stops[k + 1];
      const TileSide *left = nullptr, *right = nullptr;
      for (const TileSide& edge : edges) {
        if (edge.from <= low && high <= edge.to) left = &edge;
        if (edge.to <= low && high <= edge.from) right = &edge;
      }
      if (left != nullptr && right != nullptr) {
        parts.join(left->tile, right->tile);
      } else if (left != nullptr) {
        sides.push_back({low, high, left->tile});
      } else if (right != nullptr) {
        sides.push_back({high, low, right->tile});
      }
    }
  }
  return sides;
}

/// Cuts sides at points inside them where other sides begin: the boundary touches itself there.
std::vector<TileSide> cut_at_ends(const std::vector<TileSide>& sides, Budget& budget) {
  std::set<PlanePoint> starts;
  std::map<PlaneLine, std::vector<PlanePoint>> on;
  for (const TileSide& side : sides) {
    starts.insert(side.from);
    on[line_of(side.from, side.to)];
  }
  for (auto& [line, points] : on) {
    budget.spend(starts.size());
    for (const PlanePoint& p : starts) {
      if (is_on(p, line)) points.push_back(p);
    }
  }
  std::vector<TileSide> cut;
  for (const TileSide& side : sides) {
    std::vector<PlanePoint> stops;
    for (const PlanePoint& p : on[line_of(side.from, side.to)]) {
      if (std::min(side.from, side.to) < p && p < std::max(side.from, side.to)) stops.push_back(p);
    }
    if (side.to < side.from) std::reverse(stops.begin(), stops.end());
    stops.insert(stops.begin(), side.from);
    stops.push_back(side.to);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      cut.push_back({stops[k], stops[k + 1], side.tile});
    }
  }
  return cut;
}

/// Returns the first leaving side clockwise from the arriving side: both bound one wedge of the
/// interior.
std::size_t next_side(const TileSide& side, const std::vector<TileSide>& sides,
                      const std::vector<std::size_t>& leaving) {
  const PlanePoint back = way(side.to, side.from);
  std::size_t best = leaving[0];
  int best_half = 9;
  for (const std::size_t other : leaving) {
    const PlanePoint there = way(sides[other].from, sides[other].to);
    const int turn = turned(back, there), half = turn < 0 ? 0 : turn == 0 ? 1 : 2;
    const PlanePoint at_best = way(sides[best].from, sides[best].to);
    if (half < best_half || (half == best_half && turned(at_best, there) > 0)) {
      best = other;
      best_half = half;
    }
  }
  return best;
}

/// Starts a ring at its least corner, and drops points where the ring goes straight on.
PlaneRing in_order(const PlaneRing& ring) {
  PlaneRing corners;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const PlanePoint before = way(ring[(k + n - 1) % n], ring[k]);
    if (turned(before, way(ring[k], ring[(k + 1) % n])) != 0) corners.push_back(ring[k]);
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Splits a closed walk at each repeated point.
std::vector<PlaneRing> simple_rings(PlaneRing walk) {
  std::vector<PlaneRing> found;
  PlaneRing ring;
  std::map<PlanePoint, std::ptrdiff_t> place;
  walk.push_back(walk.front());
  for (const PlanePoint& point : walk) {
    if (const auto known = place.find(point); known != place.end()) {
      const auto at = ring.begin() + known->second;
      found.push_back(in_order({at, ring.end()}));
      for (auto passed = at; passed != ring.end(); ++passed) place.erase(*passed);
      ring.erase(at, ring.end());
    }
    place[point] = static_cast<std::ptrdiff_t>(ring.size());
    ring.push_back(point);
  }
  return found;
}

}  // namespace

mpq_class doubled_area(const PlaneRing& ring) {
  mpq_class area;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const PlanePoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    area += a.first * b.second - a.second * b.first;
  }
  return area;
}

std::vector<PlanePolygon> united(const std::vector<PlaneRing>& tiles, Budget& budget) {
  Classes parts(tiles.size());
  const std::vector<TileSide> sides = cut_at_ends(outer_sides(tiles, parts, budget), budget);
  std::map<PlanePoint, std::vector<std::size_t>> leaving;
  for (std::size_t k = 0; k < sides.size(); ++k) leaving[sides[k].from].push_back(k);
  std::map<std::size_t, std::vector<PlaneRing>> found;
  std::vector<bool> done(sides.size());
  for (std::size_t first = 0; first < sides.size(); ++first) {
    PlaneRing walk;
    for (std::size_t k = first; !done[k];) {
      done[k] = true;
      walk.push_back(sides[k].from);
      const std::vector<std::size_t>& next = leaving[sides[k].to];
      budget.spend(next.size());
      k = next_side(sides[k], sides, next);
    }
    if (walk.empty()) continue;
    for (PlaneRing& ring : simple_rings(walk)) {
      found[parts.of(sides[first].tile)].push_back(std::move(ring));
    }
  }
  std::vector<PlanePolygon> polygons;
  for (auto& [part, rings] : found) {
    PlanePolygon polygon, holes;
    for (PlaneRing& ring : rings) {
      (doubled_area(ring) > 0 ? polygon : holes).push_back(std::move(ring));
    }
    demand(polygon.size() == 1, "a component has not one outer ring");
    std::sort(holes.begin(), holes.end());
    polygon.insert(polygon.end(), holes.begin(), holes.end());
    polygons.push_back(std::move(polygon));
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

}  // namespace minkref::checker
