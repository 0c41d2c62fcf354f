#include "reference/plane/routes/joined_holes.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline plane {
namespace {

using Indices = std::vector<std::uint32_t>;

/// A growing list: trees over runs, each run at least twice as long as the next.
class GrowingEdges {
 public:
  struct Edge {
    std::uint32_t a, b;
  };

  explicit GrowingEdges(const std::vector<FilteredPoint>& points) : points_(points) {}

  void add(const std::vector<Edge>& more) {
    edges_.insert(edges_.end(), more.begin(), more.end());
    std::size_t begin = edges_.size() - more.size();
    while (!runs_.empty() && begin - runs_.back().begin < 2 * (edges_.size() - begin)) {
      begin = runs_.back().begin;
      runs_.pop_back();
    }
    std::vector<Box> boxes;
    for (std::size_t e = begin; e < edges_.size(); ++e) boxes.push_back(box_of(edges_[e]));
    runs_.push_back({begin, BoxTree(std::move(boxes))});
  }

  /// Calls report(edge) for each edge whose box meets the box, which report may make smaller.
  template <class Report>
  void query(const Box& box, Report&& report) const {
    for (const Run& run : runs_) {
      run.tree.query(box, [&](std::uint32_t e) {
        report(edges_[run.begin + e]);
        return false;
      });
    }
  }

 private:
  struct Run {
    std::size_t begin;
    BoxTree tree;
  };

  Box box_of(const Edge& edge) const {
    const FilteredPoint &a = points_[edge.a], &b = points_[edge.b];
    return {std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()),
            std::max(a.y(), b.y())};
  }

  const std::vector<FilteredPoint>& points_;
  std::vector<Edge> edges_;
  std::vector<Run> runs_;
};

/// A closed walk as a linked list with an index from points to places.
class LinkedWalk {
 public:
  struct Place {
    std::uint32_t point, before, after;
  };

  LinkedWalk(const std::vector<FilteredPoint>& points, const Indices& walk) : points_(points) {
    for (const std::uint32_t point : walk) append(point);
    const auto count = static_cast<std::uint32_t>(walk.size());
    for (std::uint32_t k = 0; k < count; ++k) link(k, k + 1 == count ? 0 : k + 1);
  }

  std::uint32_t point(std::uint32_t place) const { return places_[place].point; }
  std::uint32_t after(std::uint32_t place) const { return places_[place].after; }

  /// The place at `point` whose interior wedge holds the direction to `towards`.
  std::uint32_t corner(std::uint32_t point, std::uint32_t towards) const {
    std::uint32_t last = no_entry;
    for (const std::uint32_t place : at_.at(point)) {
      last = place;
      const std::uint32_t next = this->point(after(place)),
                          previous = this->point(places_[place].before);
      const FilteredPoint &at = points_[point], &out = points_[next], &in = points_[previous],
                          &to = points_[towards];
      const int wedge = orientation(at, out, in);
      const int after_out = orientation(at, out, to), before_in = orientation(at, to, in);
      const bool inside = wedge > 0   ? after_out > 0 && before_in > 0
                          : wedge < 0 ? after_out > 0 || before_in > 0
                                      : after_out > 0 || next == previous;
      if (inside) return place;
    }
    return last;
  }

  /// Goes from a place to the hole's place, around the hole, and back.
  void splice(std::uint32_t place, const LinkedWalk& hole, std::uint32_t from) {
    const std::uint32_t next = after(place);
    std::uint32_t last = place, at = from;
    const auto go_to = [&](std::uint32_t point) {
      const std::uint32_t fresh = append(point);
      link(last, fresh);
      last = fresh;
    };
    do {
      go_to(hole.point(at));
      at = hole.after(at);
    } while (at != from);
    if (hole.after(from) != from) go_to(hole.point(from));
    go_to(point(place));
    link(last, next);
  }

  Indices points() const {
    Indices result;
    result.reserve(places_.size());
    std::uint32_t at = 0;
    do {
      result.push_back(point(at));
      at = after(at);
    } while (at != 0);
    return result;
  }

 private:
  std::uint32_t append(std::uint32_t point) {
    const auto place = static_cast<std::uint32_t>(places_.size());
    places_.push_back({point, place, place});
    at_[point].push_back(place);
    return place;
  }
  void link(std::uint32_t first, std::uint32_t second) {
    places_[first].after = second;
    places_[second].before = first;
  }

  const std::vector<FilteredPoint>& points_;
  std::vector<Place> places_;
  std::unordered_map<std::uint32_t, Indices> at_;
};

class HoleJoining {
 public:
  HoleJoining(const std::vector<FilteredPoint>& points, const Indices& outer)
      : points_(points), walk_(points, outer), edges_(points) {
    edges_.add(edges_of(outer));
  }

  void join(const Indices& hole, std::uint32_t rightmost) {
    const std::uint32_t end = visible_vertex(rightmost);
    const LinkedWalk around(points_, hole);
    walk_.splice(walk_.corner(end, rightmost), around, around.corner(rightmost, end));
    std::vector<GrowingEdges::Edge> more = edges_of(hole);
    more.push_back({end, rightmost});
    more.push_back({rightmost, end});
    edges_.add(more);
  }

  Indices points() const { return walk_.points(); }

 private:
  /// Where a ray to the right meets the joined walks first.
  struct Hit {
    std::uint32_t a, b;  ///< the edge there
    bool is_vertex;      ///< the point is a
  };

  static std::vector<GrowingEdges::Edge> edges_of(const Indices& walk) {
    std::vector<GrowingEdges::Edge> edges;
    for (std::size_t k = 0; k < walk.size(); ++k) {
      edges.push_back({walk[k], walk[k + 1 == walk.size() ? 0 : k + 1]});
    }
    return edges;
  }

  Hit first_hit(std::uint32_t m) const {
    const FilteredPoint& at = points_[m];
    Box ray{at.x(), at.y(), std::numeric_limits<double>::infinity(), at.y()};
    bool found = false;
    Rational nearest;
    Hit hit{};
    edges_.query(ray, [&](const GrowingEdges::Edge& edge) {
      const auto [a, b] = edge;
      const int ya = compare_y(points_[a], at), yb = compare_y(points_[b], at);
      Rational x;
      if (ya == 0) {
        if (compare_x(points_[a], at) <= 0) return;
        x = points_[a].exact().x;
      } else if (ya * yb < 0) {
        // Only an edge that runs upwards has the interior on the side of m.
        if (ya > 0 || orientation(points_[a], points_[b], at) <= 0) return;
        const Point &p = points_[a].exact(), &q = points_[b].exact();
        x = p.x + (at.exact().y - p.y) / (q.y - p.y) * (q.x - p.x);
      } else {
        return;
      }
      if (found && !(x < nearest)) return;
      found = true;
      hit = {a, b, ya == 0};
      ray.xmax = to_double(x);  // rounding is monotone: nearer edges still meet the box
      nearest = std::move(x);
    });
    return hit;
  }

  /// A joined vertex visible from m, to the right.
  std::uint32_t visible_vertex(std::uint32_t m) const {
    const FilteredPoint& at = points_[m];
    const auto [a, b, is_vertex] = first_hit(m);
    if (is_vertex) return a;
    const FilteredPoint &from = points_[a], &to = points_[b];
    const bool upper = compare_x(to, from) >= 0;
    const std::uint32_t end = upper ? b : a;
    // Vertices within the triangle of m, the point hit and `end` may hide `end`: the vertex nearest
    // to the ray by angle, then by distance, is visible.
    const FilteredPoint& tip = points_[end];
    const Box triangle{at.x(), std::min(at.y(), tip.y()), tip.x(), std::max(at.y(), tip.y())};
    const int sense = upper ? 1 : -1;
    std::uint32_t best = end;
    edges_.query(triangle, [&](const GrowingEdges::Edge& edge) {
      const std::uint32_t r = edge.a;
      if (r == best || compare_y(points_[r], at) != sense) return;
      if (orientation(from, to, points_[r]) < 0) return;
      if (orientation(at, tip, points_[r]) * sense > 0) return;
      const int angle = orientation(at, points_[best], points_[r]) * sense;
      if (angle < 0 || (angle == 0 && compare_x(points_[r], points_[best]) < 0)) best = r;
    });
    return best;
  }

  const std::vector<FilteredPoint>& points_;
  LinkedWalk walk_;
  GrowingEdges edges_;
};

}  // namespace

Indices joined_holes(const std::vector<FilteredPoint>& points, const Indices& outer,
                     const std::vector<Indices>& holes) {
  if (holes.empty()) return outer;
  // Holes from right to left: a ray to the right meets only joined walks.
  const auto is_left = [&](std::uint32_t a, std::uint32_t b) {
    return compare_xy(points[a], points[b]) < 0;
  };
  std::vector<std::pair<std::uint32_t, const Indices*>> order;
  for (const Indices& hole : holes) {
    look_for_interrupt();
    order.emplace_back(*std::max_element(hole.begin(), hole.end(), is_left), &hole);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto& a, const auto& b) { return is_left(b.first, a.first); });
  HoleJoining joining(points, outer);
  for (const auto& [rightmost, hole] : order) joining.join(*hole, rightmost);
  return joining.points();
}

}  // namespace minkref::inline plane
