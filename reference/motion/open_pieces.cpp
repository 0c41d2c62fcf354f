#include "reference/motion/open_pieces.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "reference/interrupt.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline motion {
namespace {

Rational turn_at(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

struct ByCoordinates {
  bool operator()(const Point& a, const Point& b) const {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

/// Joins triangles across diagonals as long as the result is convex (Hertel & Mehlhorn 1983).
class Joining {
 public:
  explicit Joining(const std::vector<Triangle>& triangles) {
    for (const Triangle& triangle : triangles) {
      Corners corners;
      for (const Point& p : triangle) corners.push_back(number(p));
      pieces_.push_back(std::move(corners));
    }
    owner_.resize(pieces_.size());
    std::iota(owner_.begin(), owner_.end(), 0U);
  }

  std::vector<ConvexCorners> joined() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) sides[{pieces_[k][i], pieces_[k][(i + 1) % 3]}] = k;
    }
    for (const auto& [side, k] : sides) {
      look_for_interrupt();
      if (side.second < side.first) continue;
      const auto other = sides.find({side.second, side.first});
      if (other != sides.end()) join(find(k), find(other->second), side);
    }
    std::vector<ConvexCorners> result;
    for (const Corners& corners : pieces_) {
      if (corners.empty()) continue;
      ConvexCorners& piece = result.emplace_back();
      for (const std::uint32_t c : corners) piece.push_back(points_[c]);
    }
    return result;
  }

 private:
  using Corners = std::vector<std::uint32_t>;

  std::uint32_t number(const Point& p) {
    const auto [place, fresh] = numbers_.try_emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (fresh) points_.push_back(p);
    return place->second;
  }
  std::uint32_t find(std::uint32_t k) {
    while (owner_[k] != k) k = owner_[k] = owner_[owner_[k]];
    return k;
  }
  bool is_convex_at(const Corners& c, std::size_t i) const {
    const std::size_t n = c.size();
    return turn_at(points_[c[(i + n - 1) % n]], points_[c[i]], points_[c[(i + 1) % n]]) >= 0;
  }

  void join(std::uint32_t a, std::uint32_t b, std::pair<std::uint32_t, std::uint32_t> side) {
    if (a == b) return;
    Corners& first = pieces_[a];
    Corners& second = pieces_[b];
    // The first runs from the side's end round to its start; then come the second's other corners.
    const auto turned_to = [](Corners& corners, std::uint32_t start) {
      std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), start), corners.end());
    };
    turned_to(first, side.second);
    turned_to(second, side.first);
    if (first.back() != side.first || second.back() != side.second) return;
    Corners whole(first);
    whole.insert(whole.end(), second.begin() + 1, second.end() - 1);
    if (!is_convex_at(whole, 0) || !is_convex_at(whole, first.size() - 1)) return;
    first = std::move(whole);
    second.clear();
    owner_[b] = a;
  }

  std::map<Point, std::uint32_t, ByCoordinates> numbers_;
  std::vector<Point> points_;
  std::vector<Corners> pieces_;
  std::vector<std::uint32_t> owner_;
};

/// The room behind m, away from `apex`, inside a triangle with m on its border: half the greatest
/// factor of m - apex.
std::optional<Rational> room_behind(const Point& apex, const Point& m, const Triangle& triangle) {
  const Point way{m.x - apex.x, m.y - apex.y};
  std::optional<Rational> most;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = triangle[i], &b = triangle[(i + 1) % 3];
    const Rational at = turn_at(a, b, m);
    const Rational slope = (b.x - a.x) * way.y - (b.y - a.y) * way.x;
    if (at < 0 || (at == 0 && slope <= 0)) return std::nullopt;
    if (slope >= 0) continue;
    const Rational far = at / -slope;
    if (!most || far < *most) most = far;
  }
  if (!most) return std::nullopt;
  return *most / 2;
}

/// Adds kites that hold the seams: four corners, with a vertex-free part of a seam as a diagonal.
void add_kites(const PolygonSet& set, const std::vector<Triangle>& triangles,
               std::vector<ConvexCorners>& pieces) {
  std::vector<Point> vertices;
  for (const Polygon& polygon : set.polygons) {
    vertices.insert(vertices.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes)
      vertices.insert(vertices.end(), hole.begin(), hole.end());
  }
  std::sort(vertices.begin(), vertices.end(), ByCoordinates());
  for (const Triangle& triangle : triangles) {
    look_for_interrupt();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &a = triangle[i], &b = triangle[(i + 1) % 3], &apex = triangle[(i + 2) % 3];
      const ByCoordinates before;
      if (before(b, a)) continue;  // the triangle on the other side does it
      std::vector<Point> along{a};
      for (const Point& v : vertices) {
        if (before(a, v) && before(v, b) && turn_at(a, b, v) == 0) along.push_back(v);
      }
      along.push_back(b);
      for (std::size_t k = 0; k + 1 < along.size(); ++k) {
        if (along[k] == along[k + 1]) continue;
        const Point m{(along[k].x + along[k + 1].x) / 2, (along[k].y + along[k + 1].y) / 2};
        for (const Triangle& other : triangles) {
          const auto room = room_behind(apex, m, other);
          if (!room) continue;
          const Point behind{m.x + *room * (m.x - apex.x), m.y + *room * (m.y - apex.y)};
          pieces.push_back({along[k], behind, along[k + 1], apex});
        }
      }
    }
  }
}

}  // namespace

std::vector<ConvexCorners> open_pieces(const PolygonSet& set, bool open) {
  if (set.empty()) return {};
  if (!set.is_region()) return {set.polygons[0].outer};
  const std::vector<Triangle> triangles = triangulate(set);
  std::vector<ConvexCorners> pieces = Joining(triangles).joined();
  if (open) add_kites(set, triangles, pieces);
  return pieces;
}

}  // namespace minkref::inline motion
