#include "reference/scene/seam_growth.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/scene/point_cover.hpp"

namespace minkref::inline scene {
namespace {

Point plus(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
Point times(const Rational& f, const Point& p) { return {f * p.x, f * p.y}; }
Rational cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }
Rational dot(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y; }
bool is_zero(const Point& u) { return sign(u.x) == 0 && sign(u.y) == 0; }
bool less(const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

/// A part of the way along which the robot has no width: all points that it passes.
struct Stretch {
  Point from, to;
  std::uint32_t segment;
};

/// A copy: its obstacle at the factor f is place + f times its rings.
struct Growing {
  std::uint32_t copy;
  Point place;
  std::vector<std::vector<Point>> rings;

  std::vector<ObstacleEdge> edges(const Rational& f) const {
    std::vector<ObstacleEdge> found;
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        found.push_back(
            {plus(place, times(f, ring[i])), plus(place, times(f, ring[(i + 1) % ring.size()]))});
      }
    }
    return found;
  }
};

/// A point that stays on the line of a stretch: at the place `at` + f `by` along it, both times the
/// square of the stretch's length.
struct Sliding {
  std::size_t copy;
  Rational at, by;
};

class Search {
 public:
  Search(const Scene& scene, const std::vector<std::uint32_t>& near, const std::vector<Point>& path,
         const std::optional<Rational>& to)
      : robot_(scene.robot.polygons[0].outer), path_(path), to_(to) {
    for (const std::uint32_t k : near) {
      const Copy& c = scene.copies[k];
      Growing& made = growing_.emplace_back(Growing{k, c.place, {}});
      for (const Polygon& polygon : scene.shapes[c.shape].polygons) {
        add_ring(made, polygon.outer, c.scale);
        for (const auto& hole : polygon.holes) add_ring(made, hole, c.scale);
      }
    }
    find_stretches();
  }

  std::optional<Seam> first() {
    find_events();
    Rational before = 1;
    for (const Rational& event : events_) {
      if (auto seam = seam_at((before + event) / 2)) return just_above(std::move(*seam), before);
      if (auto seam = seam_at(event)) {
        seam->at = true;
        return seam;
      }
      before = event;
    }
    if (to_ && before == *to_) return std::nullopt;
    auto seam = seam_at(to_ ? Rational((before + *to_) / 2) : Rational(before + 1));
    if (!seam) return std::nullopt;
    return just_above(std::move(*seam), before);
  }

 private:
  static void add_ring(Growing& growing, const std::vector<Point>& ring, const Rational& scale) {
    auto& made = growing.rings.emplace_back();
    for (const Point& p : ring) made.push_back(times(scale, p));
  }

  static Seam just_above(Seam seam, const Rational& factor) {
    seam.factor = factor;
    return seam;
  }

  /// Parts of the way along the robot, or all of the way of a point. Beside other parts, which have
  /// an area, an obstacle's interior comes first.
  void find_stretches() {
    const Point &r = robot_.front(), &s = robot_.back();
    for (std::uint32_t k = 0; k == 0 || k + 1 < path_.size(); ++k) {
      const Point &a = path_[k], &b = path_[std::min<std::size_t>(k + 1, path_.size() - 1)];
      if (sign(cross(minus(b, a), minus(s, r))) != 0) continue;
      std::vector<Point> ends{plus(a, r), plus(a, s), plus(b, r), plus(b, s)};
      const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), less);
      stretches_.push_back({*low, *high, k});
    }
  }

  void find_events() {
    for (const Stretch& stretch : stretches_) {
      std::vector<Sliding> sliding;
      for (std::size_t k = 0; k < growing_.size(); ++k) {
        look_for_interrupt();
        for (const auto& ring : growing_[k].rings) {
          for (std::size_t i = 0; i < ring.size(); ++i) {
            add_vertex(stretch, k, ring[i], sliding);
            add_edge(stretch, growing_[k], ring[i], ring[(i + 1) % ring.size()]);
          }
        }
      }
      add_meetings(sliding);
    }
  }

  /// Adds the root of a + f b, if it lies in the window; at 1 the way is known to be free.
  void add_root(const Rational& a, const Rational& b) {
    if (sign(b) == 0) return;
    const Rational f = -a / b;
    if (f > 1 && (!to_ || f <= *to_)) events_.insert(f);
  }

  /// A vertex comes to the line of the stretch, or, sliding along it, to one of its ends.
  void add_vertex(const Stretch& stretch, std::size_t k, const Point& by,
                  std::vector<Sliding>& sliding) {
    const Point u = minus(stretch.to, stretch.from);
    const Point w = minus(growing_[k].place, stretch.from);
    if (is_zero(u)) {
      if (sign(cross(w, by)) != 0) return;
      add_root(w.x, by.x);
      add_root(w.y, by.y);
      return;
    }
    const Rational off = cross(u, w), slope = cross(u, by);
    if (sign(off) != 0 || sign(slope) != 0) {
      const Rational f = sign(slope) == 0 ? Rational(0) : Rational(-off / slope);
      const Rational along = dot(u, plus(w, times(f, by)));
      if (along >= 0 && along <= dot(u, u)) add_root(off, slope);
      return;
    }
    sliding.push_back({k, dot(u, w), dot(u, by)});
    add_root(dot(u, w), dot(u, by));
    add_root(dot(u, w) - dot(u, u), dot(u, by));
  }

  /// An end of the stretch comes to an edge.
  void add_edge(const Stretch& stretch, const Growing& growing, const Point& a, const Point& b) {
    const Point u = minus(b, a);
    for (const Point& end : {stretch.from, stretch.to}) {
      const Point w = minus(end, growing.place);
      const Rational off = cross(u, w), slope = cross(a, u);
      if (sign(slope) == 0) continue;  // never, or always: then a vertex comes to the end
      const Rational f = -off / slope;
      const Rational along = dot(u, minus(w, times(f, a)));
      if (along >= 0 && along <= f * dot(u, u)) add_root(off, slope);
    }
  }

  /// Vertices of two copies meet while sliding.
  void add_meetings(const std::vector<Sliding>& sliding) {
    for (std::size_t i = 0; i < sliding.size(); ++i) {
      look_for_interrupt();
      for (std::size_t j = 0; j < i; ++j) {
        const Sliding &one = sliding[i], &other = sliding[j];
        if (one.copy != other.copy) add_root(one.at - other.at, one.by - other.by);
      }
    }
  }

  using AllEdges = std::vector<std::vector<ObstacleEdge>>;

  /// A point of the way inside the union of several copies at the factor.
  std::optional<Seam> seam_at(const Rational& f) const {
    AllEdges all;
    for (const Growing& growing : growing_) all.push_back(growing.edges(f));
    for (const Stretch& stretch : stretches_) {
      for (const Point& p : touched(stretch, all)) {
        look_for_interrupt();
        AllEdges there;
        Seam seam{f, false, {}, place_of(stretch, p), p};
        for (std::size_t k = 0; k < all.size(); ++k) {
          const auto on = [&](const ObstacleEdge& edge) { return lies_on(edge, p); };
          if (std::none_of(all[k].begin(), all[k].end(), on)) continue;
          there.push_back(all[k]);
          seam.copies.push_back(growing_[k].copy);
        }
        if (there.size() > 1 && cover_together(there, p)) return seam;
      }
    }
    return std::nullopt;
  }

  /// Points at which copies touch a stretch, and the middles between them.
  static std::vector<Point> touched(const Stretch& stretch, const AllEdges& all) {
    const ObstacleEdge whole{stretch.from, stretch.to};
    std::vector<Point> found;
    for (const auto& edges : all) {
      look_for_interrupt();
      for (const ObstacleEdge& edge : edges) {
        if (lies_on(whole, edge.from)) found.push_back(edge.from);
        for (const Point& end : {stretch.from, stretch.to}) {
          if (lies_on(edge, end)) found.push_back(end);
        }
      }
    }
    std::sort(found.begin(), found.end(), less);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    const std::size_t count = found.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
      found.push_back(times(Rational(1, 2), plus(found[i], found[i + 1])));
    return found;
  }

  /// The first place of the robot on the stretch's segment at which it holds the point.
  PathPlace place_of(const Stretch& stretch, const Point& p) const {
    const Point& a = path_[stretch.segment];
    const Point& b = path_[std::min<std::size_t>(stretch.segment + 1, path_.size() - 1)];
    const Point d = minus(b, a);
    Rational t = 0;
    if (!is_zero(d)) {
      const auto at = [&](const Point& r) {
        return Rational(dot(d, minus(minus(p, a), r)) / dot(d, d));
      };
      t = std::max(t, std::min(at(robot_.front()), at(robot_.back())));
    }
    return {stretch.segment, t, plus(a, times(t, d))};
  }

  const std::vector<Point>& robot_;
  const std::vector<Point>& path_;
  std::optional<Rational> to_;
  std::vector<Growing> growing_;
  std::vector<Stretch> stretches_;
  std::set<Rational> events_;
};

}  // namespace

std::optional<Seam> first_seam(const Scene& scene, const std::vector<std::uint32_t>& near,
                               const std::vector<Point>& path, const std::optional<Rational>& to) {
  if (near.size() < 2) return std::nullopt;
  return Search(scene, near, path, to).first();
}

}  // namespace minkref::inline scene
