// Rings of a boundary in canonical form (docs/definitions.md), and their counts.
#pragma once

#include "oracle/sampled/boundary.hpp"
#include "oracle/sampled/events.hpp"

namespace minkref::sampled {

/// A vertex and the boundary edges that arrive and leave.
struct RingVertex {
  int point, in, out;
};

template <class Int>
struct State {
  std::vector<BoundaryEdge<Int>> edges;
  std::vector<Point<Int>> points;          ///< ascending
  std::vector<std::pair<int, int>> lines;  ///< for each point: two edges there, not parallel
  /// Rings of the canonical form, but with straight vertices where the boundary touches itself.
  std::vector<std::vector<RingVertex>> rings;
  Counts counts;
};

/// Starts each cycle at its least element, and sorts the cycles: equal iff the sets of cycles are.
template <class T>
std::vector<std::vector<T>> canonical(std::vector<std::vector<T>> cycles) {
  for (auto& cycle : cycles) {
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  }
  std::sort(cycles.begin(), cycles.end());
  return cycles;
}

/// Joins the edges of a boundary to rings.
template <class Int>
class RingMaker {
 public:
  RingMaker(const std::vector<Vec<Int>>& directions, std::vector<BoundaryEdge<Int>> edges)
      : directions_(directions) {
    state_.edges = std::move(edges);
    find_points();
    cut_edges();
    find_lines();
    state_.rings = cycles(false);
    Counts& counts = state_.counts;
    for (const auto& ring : straightened(state_.rings)) {
      ++counts.rings;
      counts.vertices += static_cast<int>(ring.size());
      counts.components += runs_left(ring);
    }
    for (const auto& ring : straightened(cycles(true))) counts.holes += !runs_left(ring);
  }

  State<Int> state() && { return std::move(state_); }

 private:
  struct SubEdge {
    int edge, from, to;
  };

  const Vec<Int>& direction(int sub_edge) const {
    const int edge = parts_[static_cast<std::size_t>(sub_edge)].edge;
    return directions_[static_cast<std::size_t>(
        state_.edges[static_cast<std::size_t>(edge)].direction)];
  }

  int number(const Point<Int>& x) const {
    const auto& points = state_.points;
    return static_cast<int>(std::lower_bound(points.begin(), points.end(), x) - points.begin());
  }

  void find_points() {
    auto& points = state_.points;
    for (const auto& e : state_.edges) {
      points.push_back(e.from);
      points.push_back(e.to);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }

  /// Cuts edges at other edges' ends inside them.
  void cut_edges() {
    leaving_.resize(state_.points.size());
    arriving_.resize(state_.points.size());
    for (std::size_t k = 0; k < state_.edges.size(); ++k) {
      const auto& e = state_.edges[k];
      const Vec<Int>& d = directions_[static_cast<std::size_t>(e.direction)];
      const int from = number(e.from), to = number(e.to);
      // Along an edge the points ascend or descend.
      const int step = from < to ? 1 : -1;
      int last = from;
      for (int x = from + step; x != to + step; x += step) {
        const Point<Int>& point = state_.points[static_cast<std::size_t>(x)];
        if (x != to && Int(d.x * point.y - d.y * point.x) != Int(e.offset * point.w)) continue;
        const int number_of_part = static_cast<int>(parts_.size());
        leaving_[static_cast<std::size_t>(last)].push_back(number_of_part);
        arriving_[static_cast<std::size_t>(x)].push_back(number_of_part);
        parts_.push_back({static_cast<int>(k), last, x});
        last = x;
      }
    }
    for (std::size_t x = 0; x < leaving_.size(); ++x) {
      if (leaving_[x].size() != arriving_[x].size()) throw Fault("the boundary does not close");
    }
  }

  void find_lines() {
    for (std::size_t x = 0; x < leaving_.size(); ++x) {
      std::pair<int, int> lines{edge_of(leaving_[x].front()), -1};
      for (const auto* parts : {&leaving_[x], &arriving_[x]}) {
        for (const int part : *parts) {
          if (cross(direction(leaving_[x].front()), direction(part)) != 0)
            lines.second = edge_of(part);
        }
      }
      if (lines.second < 0) throw Fault("the boundary goes straight on through a vertex");
      state_.lines.push_back(lines);
    }
  }

  /// Returns the first edge clockwise after an edge (both bound a wedge of the interior), or
  /// counter-clockwise (a wedge of the complement).
  int behind(int in, bool of_complement) const {
    const auto& choice =
        leaving_[static_cast<std::size_t>(parts_[static_cast<std::size_t>(in)].to)];
    if (choice.size() == 1) return choice[0];
    const Vec<Int> back = -direction(in);
    const auto side = [&](const Vec<Int>& u, const Vec<Int>& v) {
      return of_complement ? -sign(cross(u, v)) : sign(cross(u, v));
    };
    int best = choice[0];
    for (const int out : choice) {
      const Vec<Int>&d = direction(out), &b = direction(best);
      const int half = side(back, d), half_of_best = side(back, b);
      if (half != half_of_best ? half < half_of_best : side(b, d) > 0) best = out;
    }
    return best;
  }

  /// Returns closed walks, split at repeated points.
  std::vector<std::vector<RingVertex>> cycles(bool of_complement) const {
    std::vector<std::vector<RingVertex>> found;
    std::vector<bool> seen(parts_.size(), false);
    std::vector<int> place(state_.points.size(), -1), walk;
    for (std::size_t first = 0; first < parts_.size(); ++first) {
      if (seen[first]) continue;
      int k = static_cast<int>(first);
      do {
        if (seen[static_cast<std::size_t>(k)]) throw Fault("two edges go on as one");
        seen[static_cast<std::size_t>(k)] = true;
        const SubEdge& part = parts_[static_cast<std::size_t>(k)];
        place[static_cast<std::size_t>(part.from)] = static_cast<int>(walk.size());
        walk.push_back(k);
        const int back = place[static_cast<std::size_t>(part.to)];
        if (back >= 0) {
          found.push_back(ring_of(walk, static_cast<std::size_t>(back)));
          for (std::size_t m = static_cast<std::size_t>(back); m < walk.size(); ++m) {
            place[static_cast<std::size_t>(parts_[static_cast<std::size_t>(walk[m])].from)] = -1;
          }
          walk.resize(static_cast<std::size_t>(back));
        }
        k = behind(k, of_complement);
      } while (k != static_cast<int>(first));
      if (!walk.empty()) throw Fault("a walk does not close");
    }
    return found;
  }

  std::vector<RingVertex> ring_of(const std::vector<int>& walk, std::size_t begin) const {
    std::vector<RingVertex> ring;
    for (std::size_t k = begin; k < walk.size(); ++k) {
      const int in = walk[k == begin ? walk.size() - 1 : k - 1];
      ring.push_back(
          {parts_[static_cast<std::size_t>(walk[k])].from, edge_of(in), edge_of(walk[k])});
    }
    return ring;
  }
  int edge_of(int sub_edge) const { return parts_[static_cast<std::size_t>(sub_edge)].edge; }

  int direction_of_edge(int edge) const {
    return state_.edges[static_cast<std::size_t>(edge)].direction;
  }

  std::vector<std::vector<RingVertex>> straightened(
      std::vector<std::vector<RingVertex>> rings) const {
    for (auto& ring : rings) {
      std::erase_if(ring, [&](const RingVertex& v) {
        return direction_of_edge(v.in) == direction_of_edge(v.out);
      });
      if (ring.size() < 3) throw Fault("a ring has fewer than three vertices");
    }
    return rings;
  }

  /// Whether a ring runs counter-clockwise: then the ring turns left at its least vertex.
  bool runs_left(const std::vector<RingVertex>& ring) const {
    const RingVertex& least = *std::min_element(
        ring.begin(), ring.end(),
        [](const RingVertex& a, const RingVertex& b) { return a.point < b.point; });
    return cross(directions_[static_cast<std::size_t>(direction_of_edge(least.in))],
                 directions_[static_cast<std::size_t>(direction_of_edge(least.out))]) > 0;
  }

  const std::vector<Vec<Int>>& directions_;
  State<Int> state_;
  std::vector<SubEdge> parts_;
  std::vector<std::vector<int>> leaving_, arriving_;
};

}  // namespace minkref::sampled
