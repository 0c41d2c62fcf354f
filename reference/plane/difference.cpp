#include <algorithm>

#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/interior_point.hpp"
#include "reference/plane/arrangement/winding_numbers.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline plane {
namespace {

template <class Grid>
Point inner_point(const GridFrame<Grid>& frame, const Arrangement<GridKernel<Grid>>& arrangement,
                  std::uint32_t face) {
  const Point x = exact_interior_point(frame.kernel, arrangement, face);
  const Rational unit(Integer(1), frame.denominator);
  return {x.x * unit, x.y * unit};
}
Point inner_point(const ScalarFrame<Rational>& frame,
                  const Arrangement<PlainKernel<Rational>>& arrangement, std::uint32_t face) {
  const auto x = interior_point(frame.kernel, arrangement, face);
  return {x.x(), x.y()};
}

/// Whether the point lies strictly inside exactly one set and strictly outside the other; -1 if
/// not, else in_first.
int separates(const PolygonSet& first, const PolygonSet& second, const Point& x) {
  const Location a = locate(first, x), b = locate(second, x);
  if (a == Location::boundary || b == Location::boundary || a == b) return -1;
  return a == Location::inside;
}

/// The nearest multiple of 1/denominator.
Rational rounded(const Rational& value, const Integer& denominator) {
  const Rational shifted = value * denominator + Rational(1, 2);
  Integer floor = numerator(shifted) / boost::multiprecision::denominator(shifted);
  if (sign(shifted) < 0 && Rational(floor) != shifted) --floor;
  return {floor, denominator};
}

}  // namespace

std::optional<Difference> difference(const PolygonSet& first, const PolygonSet& second) {
  const FloatEnvironment standard;
  const std::optional<Point> inner =
      on_exact_frame(first, second, [](const auto& frame) -> std::optional<Point> {
        using K = typename std::decay_t<decltype(frame)>::K;
        std::vector<typename K::Vector> vertices;
        std::vector<IndexedSegment> segments;
        std::size_t of_first = 0;
        for (const auto* operand : {&frame.P, &frame.Q}) {
          for (const auto& ring : operand->rings) {
            const auto start = static_cast<std::uint32_t>(vertices.size());
            const auto size = static_cast<std::uint32_t>(ring.size());
            vertices.insert(vertices.end(), ring.begin(), ring.end());
            for (std::uint32_t i = 0; i < size; ++i)
              segments.push_back({start + i, start + (i + 1) % size});
          }
          if (operand == &frame.P) of_first = segments.size();
        }
        const Arrangement<K> arrangement(frame.kernel, std::move(vertices), std::move(segments));
        const auto in_first =
            winding_numbers(arrangement, [&](std::uint32_t s) { return s < of_first ? 1 : 0; });
        const auto in_second =
            winding_numbers(arrangement, [&](std::uint32_t s) { return s < of_first ? 0 : 1; });
        // The face with the most boundary edges' extent is likely the plainest: take the widest
        // box.
        std::optional<std::uint32_t> widest;
        double width = -1;
        for (std::uint32_t face = 1; face < arrangement.face_count(); ++face) {
          if ((in_first[face] > 0) == (in_second[face] > 0)) continue;
          Box box;
          arrangement.for_each_half_edge(face, [&](std::uint32_t h) {
            const Point p = position(frame, arrangement.node(arrangement.origin(h)));
            const double x = to_double(p.x), y = to_double(p.y);
            box.add({x, y, x, y});
          });
          const double w = std::min(box.xmax - box.xmin, box.ymax - box.ymin);
          if (!(w > width) && widest) continue;
          width = w;
          widest = face;
        }
        if (!widest) return std::nullopt;
        return inner_point(frame, arrangement, *widest);
      });
  if (!inner) return std::nullopt;
  // A point with few digits, if such a point separates the sets as well.
  Integer denominator = 1;
  for (int step = 0; step < 24; ++step, denominator *= step % 3 == 1 ? 2 : step % 3 == 2 ? 5 : 1) {
    const Point x{rounded(inner->x, denominator), rounded(inner->y, denominator)};
    if (const int side = separates(first, second, x); side >= 0) return Difference{x, side == 1};
  }
  return Difference{*inner, separates(first, second, *inner) == 1};
}

}  // namespace minkref::inline plane
