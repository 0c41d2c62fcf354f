#include "tests/fuzzing/reference/pair_change.hpp"

namespace minkref::fuzzing {
namespace {

Rational some_factor(Dice& dice) {
  if (dice.one_in(4)) return power_of_two(dice.between(-60, 60));
  const Rational factors[] = {2, Rational(1, 2), 3, Rational(1, 3), Rational(7, 5), 4};
  return dice.of(factors);
}

/// All x, all y, or both by a factor.
void stretch(const ChangeSite& c) {
  const Rational factor = some_factor(c.dice);
  const std::size_t kind = c.dice.below(3);
  map_points(c.shape, [&](const Point& p) -> Point {
    return {kind == 1 ? p.x : Rational(factor * p.x), kind == 0 ? p.y : Rational(factor * p.y)};
  });
}

/// Moves far away, by a rational that is no double, or so that a vertex meets a point of the other
/// operand.
void translate(const ChangeSite& c) {
  Point by{c.dice.between(-3, 3), c.dice.between(-3, 3)};
  switch (c.dice.below(4)) {
    case 0:
      by = {power_of_two(c.dice.between(20, 90)), -power_of_two(c.dice.between(20, 90))};
      break;
    case 1:
      by = {Rational(c.dice.between(-9, 9), 7), Rational(c.dice.between(-9, 9), 3)};
      break;
    case 2:
      by = c.some_point() - c.dice.of(c.some_ring(c.shape));
      break;
    default:
      break;
  }
  c.shape = translated(c.shape, by);
}

/// A linear map of determinant 1 or -1: sheared, turned by a right angle, mirrored.
void shear_or_turn(const ChangeSite& c) {
  const std::size_t kind = c.dice.below(4);
  const Rational by(c.dice.between(-2, 2));
  map_points(c.shape, [&](const Point& p) -> Point {
    switch (kind) {
      case 0:
        return {p.x + by * p.y, p.y};
      case 1:
        return {-p.y, p.x};
      case 2:
        return {-p.x, p.y};
      default:
        return {p.x, p.y + by * p.x};
    }
  });
}

/// Turned by the angle of a Pythagorean triple: right angles stay, denominators come.
void turn(const ChangeSite& c) {
  map_points(c.shape, [](const Point& p) -> Point {
    return {(3 * p.x - 4 * p.y) / 5, (4 * p.x + 3 * p.y) / 5};
  });
}

/// Becomes the other operand, unchanged or turned by half.
void become_other(const ChangeSite& c) {
  c.shape = c.other;
  if (c.dice.one_in(2)) {
    map_points(c.shape, [](const Point& p) -> Point { return {-p.x, -p.y}; });
  }
}

}  // namespace

std::span<const ChangeOf> operand_changes() {
  static constexpr ChangeOf all[] = {stretch,       stretch, translate,   translate,
                                     shear_or_turn, turn,    become_other};
  return all;
}

}  // namespace minkref::fuzzing
