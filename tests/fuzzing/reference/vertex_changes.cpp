#include <array>

#include "tests/fuzzing/reference/pair_change.hpp"

namespace minkref::fuzzing {

Ring& ChangeSite::some_ring(PolygonSet& set) const {
  Polygon& polygon = dice.of(set.polygons);
  const std::size_t r = dice.below(polygon.holes.size() + 1);
  return r == 0 ? polygon.outer : polygon.holes[r - 1];
}

const Ring& ChangeSite::some_ring(const PolygonSet& set) const {
  return some_ring(const_cast<PolygonSet&>(set));
}

Point ChangeSite::some_point() const {
  const auto vertex = [&](const PolygonSet& set) {
    return set.empty() ? Point{0, 0} : Point(dice.of(some_ring(set)));
  };
  switch (dice.below(6)) {
    case 0:
    case 1:
      return vertex(other);
    case 2:
      return Rational(-1) * vertex(other);
    case 3:
      return vertex(shape) + (vertex(other) - vertex(other));
    default:
      return vertex(shape);
  }
}

std::pair<Point, Point> ChangeSite::some_edge(const PolygonSet& set) const {
  const Ring& ring = some_ring(set);
  const std::size_t k = dice.below(ring.size());
  return {ring[k], ring[(k + 1) % ring.size()]};
}

namespace {

/// A step of the size of the edges around, or next to nothing.
Rational some_step(const ChangeSite& c) {
  const Rational small[] = {1,
                            1,
                            Rational(1, 2),
                            Rational(1, 3),
                            power_of_two(-10),
                            power_of_two(-20),
                            power_of_two(-50)};
  if (!c.dice.one_in(3)) return c.dice.of(small);
  const auto [from, to] = c.some_edge(c.shape);
  const Rational length = reach(to - from);
  return length / static_cast<long>(1 + c.dice.below(4));
}

/// A vertex by a step along the axes or a diagonal.
void move_vertex(const ChangeSite& c) {
  static constexpr std::array<std::pair<int, int>, 8> directions{
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  Point& p = c.dice.of(c.some_ring(c.shape));
  const auto [dx, dy] = c.dice.of(directions);
  const Rational step = some_step(c);
  p = p + Point{dx * step, dy * step};
}

/// A vertex gets the x or the y of another point.
void align_vertex(const ChangeSite& c) {
  Point& p = c.dice.of(c.some_ring(c.shape));
  const Point target = c.some_point();
  (c.dice.one_in(2) ? p.x : p.y) = c.dice.one_in(2) ? target.x : target.y;
}

/// Moves a vertex onto another vertex or onto an edge: rings touch, or the pair is refused.
void vertex_onto_boundary(const ChangeSite& c) {
  const auto [from, to] = c.some_edge(c.shape);
  const Rational along(static_cast<long>(c.dice.below(5)), 4);
  c.dice.of(c.some_ring(c.shape)) = from + along * (to - from);
}

/// Turns an edge about its start into the direction of an edge of the other operand, and sometimes
/// gives it that edge's length.
void make_parallel(const ChangeSite& c) {
  if (c.other.empty()) return;
  Ring& ring = c.some_ring(c.shape);
  const std::size_t k = c.dice.below(ring.size());
  const Point from = ring[k];
  Point& end = ring[(k + 1) % ring.size()];
  const auto [u, v] = c.some_edge(c.other);
  Point d = v - u;
  if (reach(d) == 0) return;
  if (sign(Rational((end - from).x * d.x + (end - from).y * d.y)) < 0) d = Rational(-1) * d;
  const Rational length = c.dice.one_in(2) ? Rational(1) : Rational(reach(end - from) / reach(d));
  end = from + length * d;
}

/// The fourth corner of a parallelogram: an edge gets the direction and the length of another one.
void complete_parallelogram(const ChangeSite& c) {
  Ring& ring = c.some_ring(c.shape);
  if (ring.size() < 3) return;
  const std::size_t n = ring.size(), k = c.dice.below(n);
  ring[k] = ring[(k + n - 1) % n] + (ring[(k + 1) % n] - ring[(k + 2) % n]);
}

/// A vertex on an edge, or next to it.
void insert_vertex(const ChangeSite& c) {
  Ring& ring = c.some_ring(c.shape);
  if (ring.size() < 3) return;
  const std::size_t k = c.dice.below(ring.size());
  const Point from = ring[k], edge = ring[(k + 1) % ring.size()] - from;
  const Rational off[] = {0,
                          0,
                          0,
                          power_of_two(-20),
                          -power_of_two(-20),
                          power_of_two(-40),
                          Rational(1, 4),
                          Rational(-1, 4)};
  const Rational by = c.dice.of(off);
  const Rational along(c.dice.between(1, 3), 4);
  const Point p = from + along * edge + Point{-by * edge.y, by * edge.x};
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, p);
}

/// A dent or a tooth on an edge, as wide and as high as an edge of the other operand, or nearly.
void insert_notch(const ChangeSite& c) {
  if (c.other.empty()) return;
  Ring& ring = c.some_ring(c.shape);
  if (ring.size() < 3) return;
  const std::size_t k = c.dice.below(ring.size());
  const Point from = ring[k], edge = ring[(k + 1) % ring.size()] - from;
  const auto [u, v] = c.some_edge(c.other);
  const Rational length = reach(edge);
  if (length == 0) return;
  const Rational width = reach(v - u) / length;
  if (sign(width) <= 0 || width >= 1) return;
  const Rational begin = (1 - width) * Rational(c.dice.between(1, 3), 4);
  const Rational depth = (c.dice.one_in(2) ? width : Rational(width / 2)) *
                         (c.dice.one_in(2) ? Rational(1) : Rational(-1));
  const Point inwards{-depth * edge.y, depth * edge.x};
  const Point first = from + begin * edge, last = from + (begin + width) * edge;
  std::vector<Point> notch{first, first + inwards};
  if (!c.dice.one_in(3)) notch.push_back(last + inwards);
  notch.push_back(last);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1, notch.begin(), notch.end());
}

}  // namespace

std::span<const ChangeOf> vertex_changes() {
  static constexpr ChangeOf all[] = {
      move_vertex,          move_vertex,   align_vertex,  align_vertex,
      vertex_onto_boundary, make_parallel, make_parallel, complete_parallelogram,
      insert_vertex,        insert_vertex, insert_notch};
  return all;
}

}  // namespace minkref::fuzzing
