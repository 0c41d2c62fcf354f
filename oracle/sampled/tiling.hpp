// Cuts a polygon set into convex pieces, by trying every diagonal.
#pragma once

#include "oracle/sampled/operand.hpp"

namespace minkref::sampled {

/// An edge of a subdivision with a face to its left.
struct Side {
  int from, to;
  int twin = -1;  ///< none for an edge of the set
  int next = -1, previous = -1;
  bool gone = false;
};

/// Tiles the set with boundary `edges` (indices into `points`, the set to the left). Edges meet
/// only at ends. Adds diagonals while possible, then drops each diagonal whose two faces stay
/// convex without it. O(n^3).
template <class Int>
class Tiling {
 public:
  Tiling(const std::vector<Vec<Int>>& points, const std::vector<std::pair<int, int>>& edges)
      : points_(points) {
    for (const auto& [from, to] : edges) sides_.push_back({from, to});
    add_diagonals();
    link();
    join();
  }

  std::vector<std::vector<Vec<Int>>> pieces() const {
    std::vector<std::vector<Vec<Int>>> found;
    std::vector<bool> seen(sides_.size(), false);
    for (std::size_t first = 0; first < sides_.size(); ++first) {
      if (seen[first] || sides_[first].gone) continue;
      std::vector<Vec<Int>> ring;
      for (std::size_t k = first; !seen[k]; k = static_cast<std::size_t>(sides_[k].next)) {
        seen[k] = true;
        ring.push_back(points_[static_cast<std::size_t>(sides_[k].from)]);
      }
      found.push_back(std::move(ring));
    }
    return found;
  }

 private:
  const Vec<Int>& point(int k) const { return points_[static_cast<std::size_t>(k)]; }
  Vec<Int> direction(const Side& side) const { return point(side.to) - point(side.from); }

  int turn(int a, int b, int c) const {
    return sign(cross<Int>(point(b) - point(a), point(c) - point(a)));
  }
  bool strictly_between(int a, int b, int x) const {
    return x != a && x != b && turn(a, b, x) == 0 &&
           dot<Int>(point(a) - point(x), point(b) - point(x)) < 0;
  }
  bool crosses(int a, int b, const Side& side) const {
    const int c = side.from, d = side.to;
    if (a == c || a == d || b == c || b == d) return false;
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

  /// Whether the direction from a to b leads into the set: between an edge that leaves a and the
  /// next edge counter-clockwise, which arrives.
  bool leads_inside(int a, int b) const {
    const Vec<Int> d = point(b) - point(a);
    for (const Side& out : sides_) {
      if (out.from != a || out.twin >= 0) continue;
      const Vec<Int> u = direction(out);
      const Vec<Int>* last = nullptr;
      std::vector<Vec<Int>> ends;
      for (const Side& in : sides_) {
        if (in.to == a && in.twin < 0) ends.push_back(-direction(in));
      }
      for (const Vec<Int>& w : ends) {
        if (last == nullptr || within_turn(u, w, *last)) last = &w;
      }
      if (last != nullptr && within_turn(u, d, *last)) return true;
    }
    return false;
  }

  void add_diagonals() {
    const int n = static_cast<int>(points_.size());
    std::set<std::pair<int, int>> taken;
    for (const Side& side : sides_) {
      taken.insert(std::minmax({side.from, side.to}));
    }
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        if (taken.count({a, b}) > 0 || !leads_inside(a, b)) continue;
        bool is_free = true;
        for (int x = 0; x < n && is_free; ++x) is_free = !strictly_between(a, b, x);
        for (std::size_t k = 0; k < sides_.size() && is_free; ++k) {
          is_free = !crosses(a, b, sides_[k]);
        }
        if (!is_free) continue;
        const int k = static_cast<int>(sides_.size());
        sides_.push_back({a, b, k + 1});
        sides_.push_back({b, a, k});
      }
    }
  }

  /// Links each side to the first side clockwise behind it.
  void link() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const Vec<Int> back = -direction(sides_[k]);
      int best = -1;
      for (std::size_t m = 0; m < sides_.size(); ++m) {
        if (sides_[m].from != sides_[k].to || sides_[k].twin == static_cast<int>(m)) continue;
        // Clockwise from `best`: within the turn from `best` to `back`.
        if (best < 0 || within_turn(direction(sides_[static_cast<std::size_t>(best)]),
                                    direction(sides_[m]), back)) {
          best = static_cast<int>(m);
        }
      }
      if (best < 0 || sides_[static_cast<std::size_t>(best)].previous >= 0) {
        throw BadOperand("the rings do not bound a set");
      }
      sides_[k].next = best;
      sides_[static_cast<std::size_t>(best)].previous = static_cast<int>(k);
    }
  }

  Side& side(int k) { return sides_[static_cast<std::size_t>(k)]; }

  bool stays_convex(int in, int out) {
    const Vec<Int> u = direction(side(in)), v = direction(side(out));
    const int t = sign(cross(u, v));
    return t > 0 || (t == 0 && dot(u, v) > 0);
  }

  void join() {
    for (std::size_t n = 0; n < sides_.size(); ++n) {
      const int k = static_cast<int>(n), twin = side(k).twin;
      if (twin < k || side(k).gone) continue;
      const int before = side(k).previous, after = side(k).next;
      const int other_before = side(twin).previous, other_after = side(twin).next;
      if (!stays_convex(before, other_after) || !stays_convex(other_before, after)) continue;
      side(k).gone = side(twin).gone = true;
      side(before).next = other_after;
      side(other_after).previous = before;
      side(other_before).next = after;
      side(after).previous = other_before;
    }
  }

  const std::vector<Vec<Int>>& points_;
  std::vector<Side> sides_;
};

}  // namespace minkref::sampled
