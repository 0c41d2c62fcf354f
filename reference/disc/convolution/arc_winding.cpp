#include "reference/disc/convolution/arc_winding.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {
namespace {

/// Union-find over cycles with known differences of winding numbers; the last element is the
/// outside.
class WindingSums {
 public:
  explicit WindingSums(std::uint32_t count) : parents_(count), steps_(count, 0) {
    for (std::uint32_t k = 0; k < count; ++k) parents_[k] = k;
  }

  /// The root of k, and k's number minus the root's number.
  std::pair<std::uint32_t, int> find(std::uint32_t k) {
    std::uint32_t root = k;
    int sum = 0;
    for (; parents_[root] != root; root = parents_[root]) sum += steps_[root];
    for (int left = sum; parents_[k] != root && k != root;) {
      const std::uint32_t up = std::exchange(parents_[k], root);
      left -= std::exchange(steps_[k], left);
      k = up;
    }
    return {root, sum};
  }

  /// Records that a's number exceeds b's by `step`.
  void relate(std::uint32_t a, std::uint32_t b, int step) {
    const auto [root_of_a, of_a] = find(a);
    const auto [root_of_b, of_b] = find(b);
    if (root_of_a == root_of_b) {
      if (of_a - of_b != step) throw std::logic_error("winding numbers do not add up");
      return;
    }
    parents_[root_of_a] = root_of_b;
    steps_[root_of_a] = step + of_b - of_a;
  }

 private:
  std::vector<std::uint32_t> parents_;
  std::vector<int> steps_;
};

/// A piece at the height of a ray.
struct OnRay {
  std::uint32_t piece;
  Interval x;
};

class FaceFinder {
 public:
  explicit FaceFinder(const ArcArrangement& arrangement)
      : arrangement_(arrangement),
        outside_(arrangement.cycles()),
        sums_(outside_ + 1),
        faces_(outside_ + 1) {}

  ArcFaces run() {
    const auto& pieces = arrangement_.pieces();
    std::vector<plane::Box> boxes;
    std::vector<std::uint32_t> by_height;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const std::uint32_t left = arrangement_.cycle(2 * k), right = arrangement_.cycle(2 * k + 1);
      sums_.relate(left, right, arrangement_.span(2 * k).multiplicity);
      boxes.push_back(box_of(arrangement_.nodes().position(pieces[k].from)));
      boxes.back().add(box_of(arrangement_.nodes().position(pieces[k].to)));
      if (rises(k) != 0) by_height.push_back(k);
    }
    // Long pieces first: their heights leave the most room between nodes.
    const auto height = [&](std::uint32_t k) { return boxes[k].ymax - boxes[k].ymin; };
    std::stable_sort(by_height.begin(), by_height.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return height(a) > height(b); });
    tree_ = plane::BoxTree(boxes);
    for (const std::uint32_t k : by_height) {
      look_for_interrupt();
      if (!is_related_to_outside(arrangement_.cycle(2 * k))) shoot(k, boxes[k]);
    }
    return result();
  }

 private:
  const ArcCarrier& carrier(std::uint32_t piece) const {
    return arrangement_.curves().carriers[arrangement_.span(2 * piece).carrier];
  }

  /// Whether the piece runs upwards (1), downwards (-1) or horizontally (0).
  int rises(std::uint32_t piece) const {
    const ArcCarrier& own = carrier(piece);
    if (!own.is_circle) return own.way.y.sign();
    const int quadrant = arrangement_.span(2 * piece).quadrant;
    return quadrant == 0 || quadrant == 3 ? 1 : -1;
  }
  std::uint32_t left_cycle(std::uint32_t piece) const {
    return arrangement_.cycle(rises(piece) > 0 ? 2 * piece : 2 * piece + 1);
  }
  std::uint32_t right_cycle(std::uint32_t piece) const {
    return arrangement_.cycle(rises(piece) > 0 ? 2 * piece + 1 : 2 * piece);
  }

  bool is_related_to_outside(std::uint32_t cycle) {
    return sums_.find(cycle).first == sums_.find(outside_).first;
  }

  /// A piece's ends, the lower first; the piece must not be horizontal.
  std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t piece) const {
    const ArcPiece& own = arrangement_.pieces()[piece];
    return rises(piece) > 0 ? std::pair(own.from, own.to) : std::pair(own.to, own.from);
  }

  /// The sign of a node's height minus a ray's.
  int side(std::uint32_t node, const Rational& y, const Interval& near) const {
    const Interval& own = arrangement_.nodes().position(node).y;
    if (own.upper() < near.lower()) return -1;
    if (own.lower() > near.upper()) return 1;
    return sign(arrangement_.nodes().exact(node).y - y);
  }

  /// Two numbers between the heights of a lower and a higher node.
  std::pair<Rational, Rational> between(std::uint32_t low, std::uint32_t high) const {
    const double above = arrangement_.nodes().position(low).y.upper(),
                 below = arrangement_.nodes().position(high).y.lower();
    if (above < below) return {Rational(above), Rational(below)};
    for (long bits = 128;; bits *= 2) {
      const MpfrInterval from = arrangement_.nodes().exact(low).y.enclosure(bits),
                         to = arrangement_.nodes().exact(high).y.enclosure(bits);
      if (from.is_below(to)) return {from.high(), to.low()};
    }
  }

  template <class N>
  N place(std::uint32_t piece, const N& y) const {
    const ArcCarrier& own = carrier(piece);
    if (!own.is_circle) {
      const Vector<N> normal = numbers<N>(own.normal());
      return (N(own.level) + N(own.side) * sqrt(N(own.squared_reach)) - normal.y * y) / normal.x;
    }
    const N up = y - N(own.centre.y);
    const N root = sqrt(N(arrangement_.curves().squared_radius) - up * up);
    return rises(piece) > 0 ? N(own.centre.x) + root : N(own.centre.x) - root;
  }

  /// Shoots a ray from a piece to the left, at some height within the piece but without nodes.
  void shoot(std::uint32_t piece, const plane::Box& box) {
    const auto [lower, upper] = ends(piece);
    const auto [low, high] = between(lower, upper);
    for (int part = 2;; ++part) {
      const Rational y = low + (high - low) / part;
      if (shoot_at(piece, y, box.xmax)) return;
    }
  }

  /// Relates the cycles along a ray; returns false if a node lies at the ray's height.
  bool shoot_at(std::uint32_t piece, const Rational& y, double xmax) {
    const Interval near(y);
    std::vector<OnRay> met;
    const plane::Box ray{-std::numeric_limits<double>::infinity(), near.lower(), xmax,
                         near.upper()};
    const bool is_at_node = tree_.query(ray, [&](std::uint32_t k) {
      if (rises(k) == 0) {
        return side(arrangement_.pieces()[k].from, y, near) == 0;
      }
      const auto [lower, upper] = ends(k);
      const int from = side(lower, y, near), to = side(upper, y, near);
      if (from == 0 || to == 0) return true;
      if (from < 0 && to > 0) met.push_back({k, place(k, near)});
      return false;
    });
    if (is_at_node) return false;
    std::sort(met.begin(), met.end(), [&](const OnRay& a, const OnRay& b) {
      if (a.piece == b.piece || a.x.upper() < b.x.lower()) return a.piece != b.piece;
      if (a.x.lower() > b.x.upper()) return false;
      return compare(place(a.piece, RootNumber(y)), place(b.piece, RootNumber(y))) < 0;
    });
    std::uint32_t left = outside_;
    for (const OnRay& each : met) {
      const std::uint32_t cycle = left_cycle(each.piece);
      sums_.relate(cycle, left, 0);
      faces_.join(cycle, left);
      if (each.piece == piece) break;  // beyond it not all are there
      left = right_cycle(each.piece);
    }
    return true;
  }

  ArcFaces result() {
    ArcFaces found;
    std::vector<std::uint32_t> number(outside_ + 1, OffsetPatch::none);
    const auto [root, outside] = sums_.find(outside_);
    for (std::uint32_t k = 0; k <= outside_; ++k) {
      const auto [own_root, own] = sums_.find(k);
      if (own_root != root) throw std::logic_error("a part of a convolution is nowhere");
      std::uint32_t& face = number[faces_.root(k)];
      if (face == OffsetPatch::none) {
        face = static_cast<std::uint32_t>(found.winding.size());
        found.winding.push_back(own - outside);
        if (own < outside) throw std::logic_error("a negative winding number");
      } else if (found.winding[face] != own - outside) {
        throw std::logic_error("a face has two winding numbers");
      }
      found.of_cycle.push_back(face);
    }
    found.of_cycle.pop_back();
    return found;
  }

  const ArcArrangement& arrangement_;
  std::uint32_t outside_;
  WindingSums sums_;
  DisjointSets faces_;
  plane::BoxTree tree_;
};

}  // namespace

ArcFaces arc_faces(const ArcArrangement& arrangement) { return FaceFinder(arrangement).run(); }

}  // namespace minkref::inline disc
