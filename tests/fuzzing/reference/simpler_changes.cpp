#include "tests/fuzzing/reference/pair_change.hpp"

namespace minkref::fuzzing {
namespace {

template <class Items>
void drop(Items& items, std::size_t i) {
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
}

void drop_vertex(const ChangeSite& c) {
  Ring& ring = c.some_ring(c.shape);
  if (ring.size() > 3) drop(ring, c.dice.below(ring.size()));
}

void drop_hole(const ChangeSite& c) {
  Polygon& polygon = c.dice.of(c.shape.polygons);
  if (!polygon.holes.empty()) drop(polygon.holes, c.dice.below(polygon.holes.size()));
}

void drop_polygon(const ChangeSite& c) {
  if (c.shape.polygons.size() > 1) drop(c.shape.polygons, c.dice.below(c.shape.polygons.size()));
}

/// The nearest multiple of a unit.
Rational rounded(const Rational& value, const Rational& unit) {
  const Rational steps = value / unit + Rational(1, 2);
  Integer floor = numerator(steps) / denominator(steps);
  if (Rational(floor) > steps) --floor;
  return unit * Rational(floor);
}

/// Rounds one coordinate, or all coordinates, to a grid.
void round_coordinates(const ChangeSite& c) {
  const Rational units[] = {1, 1, Rational(1, 2), Rational(1, 4), 8, power_of_two(-16)};
  const Rational unit = c.dice.of(units);
  if (c.dice.one_in(2)) {
    Point& p = c.dice.of(c.some_ring(c.shape));
    Rational& coordinate = c.dice.one_in(2) ? p.x : p.y;
    coordinate = rounded(coordinate, unit);
    return;
  }
  map_points(c.shape,
             [&](const Point& p) -> Point { return {rounded(p.x, unit), rounded(p.y, unit)}; });
}

/// A vertex at the origin.
void to_origin(const ChangeSite& c) {
  const Point first = c.dice.of(c.some_ring(c.shape));
  c.shape = translated(c.shape, Rational(-1) * first);
}

void halve(const ChangeSite& c) { c.shape = scaled(c.shape, Rational(1, 2)); }

/// One vertex half the way to the origin or to its neighbour.
void shorten(const ChangeSite& c) {
  Ring& ring = c.some_ring(c.shape);
  const std::size_t k = c.dice.below(ring.size());
  const Point to = c.dice.one_in(2) ? Point{0, 0} : ring[(k + 1) % ring.size()];
  const Point middle = Rational(1, 2) * (ring[k] + to);
  ring[k] = {rounded(middle.x, 1), rounded(middle.y, 1)};
}

}  // namespace

std::span<const ChangeOf> simpler_changes() {
  static constexpr ChangeOf all[] = {
      drop_vertex,       drop_vertex, drop_vertex,       drop_hole, drop_polygon,
      round_coordinates, shorten,     round_coordinates, to_origin, halve};
  return all;
}

}  // namespace minkref::fuzzing
