#include <algorithm>

#include "tests/fuzzing/reference/pair_change.hpp"

namespace minkref::fuzzing {
namespace {

struct Extent {
  Point low, size;
};

Extent extent(const Ring& ring) {
  Point low = ring.front(), high = ring.front();
  for (const Point& p : ring) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {larger(high.x, p.x), larger(high.y, p.y)};
  }
  return {low, high - low};
}

/// Exactly, by a hair too much or too little, or clearly.
Rational some_fit(Dice& dice) {
  const Rational fits[] = {1,
                           1,
                           1,
                           1 + power_of_two(-20),
                           1 - power_of_two(-20),
                           1 + power_of_two(-60),
                           Rational(3, 2),
                           Rational(1, 2)};
  return dice.of(fits);
}

/// A random polygon with holes, or null.
Polygon* holed(const ChangeSite& c) {
  std::vector<Polygon*> found;
  for (Polygon& polygon : c.shape.polygons) {
    if (!polygon.holes.empty()) found.push_back(&polygon);
  }
  return found.empty() ? nullptr : c.dice.of(found);
}

void move(Ring& ring, const Point& by) {
  for (Point& p : ring) p = p + by;
}

/// Adds a hole in the other operand's form, turned by half, with an exact or almost exact fit.
/// Places the hole inside the box, or with a vertex at an outer ring's vertex.
void add_hole(const ChangeSite& c) {
  if (!c.shape.is_region() || c.other.empty()) return;
  Polygon& polygon = c.dice.of(c.shape.polygons);
  Ring hole = c.dice.of(c.other.polygons).outer;
  if (hole.size() < 3) return;
  const Rational factor = -some_fit(c.dice);
  for (Point& p : hole) p = factor * p;
  const Extent outer = extent(polygon.outer), inner = extent(hole);
  const Point room = outer.size - inner.size;
  const Rational u(c.dice.between(1, 7), 8), v(c.dice.between(1, 7), 8);
  Point to = outer.low + Point{u * room.x, v * room.y} - inner.low;
  if (c.dice.one_in(4)) to = c.dice.of(polygon.outer) - c.dice.of(hole);
  move(hole, to);
  polygon.holes.push_back(std::move(hole));
}

/// A small rectangle or triangle as a hole.
void add_plain_hole(const ChangeSite& c) {
  if (!c.shape.is_region()) return;
  Polygon& polygon = c.dice.of(c.shape.polygons);
  const Extent box = extent(polygon.outer);
  const auto part = [&](long low, long high) { return Rational(c.dice.between(low, high), 8); };
  const Point from = box.low + Point{part(0, 6) * box.size.x, part(0, 6) * box.size.y};
  const Point size{part(1, 4) * box.size.x, part(1, 4) * box.size.y};
  Ring hole{from, from + Point{0, size.y}, from + size, from + Point{size.x, 0}};
  if (c.dice.one_in(3)) hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(c.dice.below(4)));
  polygon.holes.push_back(std::move(hole));
}

/// A hole stretched to the width and the height of the other operand, or nearly.
void fit_hole(const ChangeSite& c) {
  Polygon* polygon = holed(c);
  if (polygon == nullptr || c.other.empty()) return;
  Ring& hole = c.dice.of(polygon->holes);
  const Extent box = extent(hole), wanted = extent(c.dice.of(c.other.polygons).outer);
  if (sign(box.size.x) == 0 || sign(box.size.y) == 0) return;
  Point factor{some_fit(c.dice) * wanted.size.x / box.size.x,
               some_fit(c.dice) * wanted.size.y / box.size.y};
  if (c.dice.one_in(3)) factor.x = 1;
  if (c.dice.one_in(3)) factor.y = 1;
  for (Point& p : hole) {
    const Point from_low = p - box.low;
    p = box.low + Point{factor.x * from_low.x, factor.y * from_low.y};
  }
}

/// Moves a hole so that one vertex meets another ring's vertex.
void move_hole(const ChangeSite& c) {
  Polygon* polygon = holed(c);
  if (polygon == nullptr) return;
  Ring& hole = c.dice.of(polygon->holes);
  const Point target = c.dice.of(c.some_ring(c.shape));
  move(hole, target - c.dice.of(hole));
}

/// An island in a hole: the hole itself, smaller, or with a corner in a corner.
void add_island(const ChangeSite& c) {
  const Polygon* polygon = holed(c);
  if (polygon == nullptr) return;
  Ring island = c.dice.of(polygon->holes);
  const Point fixed = c.dice.one_in(2) ? c.dice.of(island)
                                       : Rational(1, 2) * (island[0] + island[island.size() / 2]);
  const Rational factor(1, c.dice.between(2, 4));
  for (Point& p : island) p = fixed + factor * (p - fixed);
  c.shape.polygons.push_back({std::move(island), {}});
}

/// Replaces a polygon with a polygon of the other operand, or adds that polygon: far away, or
/// vertex at vertex.
void copy_part(const ChangeSite& c) {
  if (c.other.empty()) return;
  Polygon part = c.dice.of(c.other.polygons);
  if (!c.shape.empty() && c.dice.one_in(2)) {
    c.dice.of(c.shape.polygons) = std::move(part);
    return;
  }
  if (c.shape.is_region() && part.outer.size() > 2) {
    const Extent mine = extent(c.dice.of(c.shape.polygons).outer), its = extent(part.outer);
    Point by = mine.low - its.low + Point{mine.size.x + static_cast<long>(c.dice.below(3)), 0};
    if (c.dice.one_in(2)) by = c.dice.of(c.some_ring(c.shape)) - c.dice.of(part.outer);
    move(part.outer, by);
    for (Ring& hole : part.holes) move(hole, by);
    c.shape.polygons.push_back(std::move(part));
    return;
  }
  c.shape.polygons = {std::move(part)};
}

/// Adds a polygon's mirror image in one vertex: both polygons touch there.
void add_touching(const ChangeSite& c) {
  if (!c.shape.is_region()) return;
  Polygon copy = c.dice.of(c.shape.polygons);
  const Point at = c.dice.of(copy.outer);
  const auto mirrored = [&](Ring& ring) {
    for (Point& p : ring) p = Rational(2) * at - p;
  };
  mirrored(copy.outer);
  if (c.dice.one_in(2)) copy.holes.clear();
  for (Ring& hole : copy.holes) mirrored(hole);
  c.shape.polygons.push_back(std::move(copy));
}

/// A part of the operand alone: a point, a segment, or a triangle of it; the empty set, seldom.
void degenerate(const ChangeSite& c) {
  const auto [from, to] = c.some_edge(c.shape);
  switch (c.dice.below(8)) {
    case 0:
      c.shape.polygons.clear();
      return;
    case 1:
    case 2:
      c.shape.polygons = {Polygon{{from}, {}}};
      return;
    case 3:
    case 4:
    case 5:
      c.shape.polygons = {Polygon{{from, to}, {}}};
      return;
    default:
      c.shape.polygons = {Polygon{{from, to, c.some_point()}, {}}};
  }
}

/// A polygon rounded about a point or a segment, so that one may have area again.
void thicken(const ChangeSite& c) {
  const auto [from, to] = c.some_edge(c.shape);
  const Rational by(c.dice.between(1, 3));
  const Point low{std::min(from.x, to.x) - by, std::min(from.y, to.y) - by};
  const Point high{larger(from.x, to.x) + by, larger(from.y, to.y) + by};
  if (c.shape.is_region() && !c.dice.one_in(4)) return;
  c.shape.polygons = {Polygon{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}};
}

}  // namespace

std::span<const ChangeOf> ring_changes() {
  static constexpr ChangeOf all[] = {add_hole,  add_hole,     add_plain_hole, fit_hole,
                                     fit_hole,  move_hole,    add_island,     copy_part,
                                     copy_part, add_touching, degenerate,     thicken};
  return all;
}

}  // namespace minkref::fuzzing
