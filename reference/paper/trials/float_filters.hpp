// Filters on trial: results that bounded doubles and the kernels' filters call certain are true.
#pragma once

#include <array>
#include <vector>

#include "reference/number/bounded_double.hpp"
#include "reference/paper/trials/float_trial.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::float_trial {

inline void judge(Counts& counts, const char* what, const BoundedDouble& found,
                  const Rational& exact) {
  const int certain = found.certain_sign();
  bool right = certain == BoundedDouble::undecided || certain == sign_of(exact);
  if (std::isfinite(found.value) && std::isfinite(found.error)) {
    right = right && abs(Rational(from_double(found.value) - exact)) <= from_double(found.error);
  }
  counts.add(what, right);
}

inline void try_bounded_doubles(Numbers& numbers, Counts& counts) {
  const unsigned words = numbers.coin() ? 1 : 1 + static_cast<unsigned>(numbers.below(20));
  const auto number = [&]() -> Integer {
    return numbers.coin() ? Integer(numbers.word(27)) : numbers.integer(words);
  };
  const Integer a = number(), b = number(),
                c = numbers.coin() ? Integer(a + numbers.word(2)) : number();
  const long shift = numbers.coin() ? 0 : static_cast<long>(numbers.below(1200));
  const Rational unit(Integer(1), Integer(1) << static_cast<unsigned long>(shift));
  const Rational p = unit * Rational(a), q = unit * Rational(b), r = unit * Rational(c);
  const BoundedDouble x(a, shift), y(b, shift), z(c, shift);
  judge(counts, "bounded integer", x, p);
  judge(counts, "bounded sum", x + y, p + q);
  judge(counts, "bounded difference", x - z, p - r);
  judge(counts, "bounded product", x * y, p * q);
  judge(counts, "bounded determinant", x * y - y * z, p * q - q * r);
  judge(counts, "bounded triple product", (x - y) * (x + z) * y, (p - q) * (p + r) * q);
  if (c.is_zero()) return;
  judge(counts, "bounded quotient", x / z, p / r);
  judge(counts, "bounded remainder", x - y * (x / z), p - q * (p / r));
}

template <class Grid>
void try_grid(Numbers& numbers, Counts& counts, const char* what, unsigned bits) {
  using K = GridKernel<Grid>;
  using Int = typename Grid::Int;
  using Wide = typename Grid::Wide;
  const K kernel;
  const auto product = [&](std::int64_t factor, std::int64_t n, std::int64_t more) {
    return Int(Int(factor) * Int(n) + Int(more));
  };
  const std::int64_t dx = numbers.word(bits), dy = numbers.word(bits), m = numbers.word(bits),
                     n = numbers.word(bits);
  const typename K::Vector u(product(m, dx, numbers.word(2)), product(m, dy, numbers.word(2)));
  const typename K::Vector v(product(n, dx, numbers.word(2)), product(n, dy, numbers.word(2)));
  const auto exact = [](const auto& x) { return Rational(grid_integer(x)); };
  const Rational cross = exact(u.x()) * exact(v.y()) - exact(u.y()) * exact(v.x());
  counts.add(what, kernel.turn(u, v) == sign_of(cross));
  if (v.x() == 0 || v.y() == 0) return;
  const auto s = K::parameter(Wide(u.x()), Wide(v.x())), t = K::parameter(Wide(u.y()), Wide(v.y()));
  const Rational difference = K::exact(s) - K::exact(t);
  counts.add(what, kernel.compare(s, t) == sign_of(difference));
  const Wide slope = Wide(v.x()),
             value = Wide(-u.x()) + Wide(static_cast<int>(numbers.below(3)) - 1);
  counts.add(what, kernel.sign_of_linear(slope, value, s) ==
                       sign_of(Rational(exact(slope) * K::exact(s) + exact(value))));
  const typename K::Query at{numbers.finite(), numbers.finite()};
  const Rational wx = from_double(at.x) - exact(u.x()), wy = from_double(at.y) - exact(u.y());
  counts.add(what,
             kernel.side(u, v, at) == sign_of(Rational(exact(v.x()) * wy - exact(v.y()) * wx)));
}

inline void try_points(Numbers& numbers, Counts& counts) {
  const Rational denominator(Integer(numbers.word(20)) * 2 + 1);
  const bool any = numbers.coin();
  const auto coordinate = [&] {
    return Rational((any ? from_double(numbers.finite()) : Rational(numbers.word(30))) /
                    denominator);
  };
  const auto beside = [&](const Point& p) -> Point {
    return numbers.coin() ? p : Point{p.x + Rational(numbers.word(2)) / (1 << 30), p.y};
  };
  const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
  const Rational t = Rational(numbers.word(8)) / 16;
  const Point c = beside({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  const FilteredPoint x(a), y(b), z(c);
  const Rational turned = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  counts.add("points of the plane", orientation(x, y, z) == sign_of(turned));
  counts.add("points of the plane", compare_x(x, z) == sign_of(Rational(a.x - c.x)));
}

inline void try_vertices(Numbers& numbers, Counts& counts) {
  const unsigned words = 1 + static_cast<unsigned>(numbers.below(8));
  const auto vector = [&] {
    return IntegerVector{numbers.integer(words), numbers.integer(words), numbers.integer(words)};
  };
  std::vector<IntegerVector> points{vector(), vector(), vector(), {}};
  const Integer s = numbers.word(8), t = numbers.word(8);
  for (std::size_t k = 0; k < 3; ++k) {
    points[3][k] = points[0][k] + s * (points[1][k] - points[0][k]) +
                   t * (points[2][k] - points[0][k]) + numbers.word(2);
  }
  const auto side = [&](std::size_t v) {
    return IntegerVector{points[v][0] - points[0][0], points[v][1] - points[0][1],
                         points[v][2] - points[0][2]};
  };
  const IntegerVector x = side(1), y = side(2), z = side(3);
  const Integer det = (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] +
                      (x[0] * y[1] - x[1] * y[0]) * z[2];
  const VertexSigns signs(points);
  counts.add("vertices in space", signs.orientation(0, 1, 2, 3) == det.sign());
  counts.add("vertices in space",
             signs.turn(0, 1, 3, 2) == Integer(x[0] * z[1] - x[1] * z[0]).sign());
}

}  // namespace minkref::float_trial
