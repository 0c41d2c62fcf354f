// Horizontal rays through segments and arcs, in any arithmetic.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/paper/disc/curve_cycles.hpp"

namespace minkref::inline disc {

/// A height without nodes, and the rising half-edges met there, from left to right.
template <class T>
struct CurveRay {
  struct Hit {
    std::uint32_t rising;
    T x;
  };
  T y;
  std::vector<Hit> hits;
};

template <class T>
class CurveRays {
 public:
  CurveRays(const CurveCycles<T>& cycles, const Arithmetic<T>& in) : cycles_(cycles), in_(in) {}

  /// A ray across a piece; none for a flat piece, or if the arithmetic has no number between its
  /// ends' heights. O(n log n).
  std::optional<CurveRay<T>> through(std::uint32_t piece) const {
    const CutCurve& own = placed().curves()[piece];
    const T &from = placed().place(own.from).y, &to = placed().place(own.to).y;
    const int way = order_of(to, from);
    if (way == 0) return std::nullopt;
    for (const int sixty_fourths : {32, 24, 40, 27, 37, 21, 43, 11, 53, 5, 59, 1, 63}) {
      const auto y = way > 0 ? between(from, to, sixty_fourths) : between(to, from, sixty_fourths);
      if (!y) continue;
      if (auto ray = at_height(*y)) return ray;
    }
    return std::nullopt;
  }

  /// A short number strictly between two numbers; none if the arithmetic has none.
  std::optional<T> between(const T& low, const T& high, int sixty_fourths = 32) const {
    const double part = sixty_fourths / 64.0, a = approximate(low), b = approximate(high);
    const double near = a + (b - a) * part;
    const auto is_between = [&](const T& x) {
      return order_of(low, x) < 0 && order_of(x, high) < 0;
    };
    if (std::isfinite(near)) {
      const T rounded = in_(from_double(near));
      if (is_between(rounded)) return rounded;
    }
    const T exact(low + T(high - low) * in_(from_double(part)));
    if (is_between(exact)) return exact;
    return std::nullopt;
  }

 private:
  const PlacedCurves<T>& placed() const { return cycles_.placed(); }

  std::optional<CurveRay<T>> at_height(const T& y) const {
    CurveRay<T> ray{y, {}};
    const std::vector<CutCurve>& curves = placed().curves();
    for (std::uint32_t k = 0; k < curves.size(); ++k) {
      const int from = order_of(placed().place(curves[k].from).y, y),
                to = order_of(placed().place(curves[k].to).y, y);
      if (from == 0 || to == 0) return std::nullopt;
      if (from == to) continue;
      ray.hits.push_back({from < 0 ? 2 * k : 2 * k + 1, x_of(curves[k], y)});
    }
    std::sort(ray.hits.begin(), ray.hits.end(),
              [](const auto& a, const auto& b) { return order_of(a.x, b.x) < 0; });
    return ray;
  }

  T x_of(const CutCurve& curve, const T& y) const {
    const MovingFeature<T>& own = placed().feature(curve.covers[0].feature);
    if (!own.is_arc) {
      const Vector<T>& from = placed().place(curve.from);
      // A wrong formula may put a place beside its segment's line.
      const Vector<T> along =
          sign(own.along.y) != 0 ? own.along : Vector<T>(placed().place(curve.to) - from);
      return T(from.x + T(y - from.y) * along.x / along.y);
    }
    const T radius(placed().at().s * placed().at().r), up(y - own.centre().y);
    const T out = detail::root_or_zero(T(radius * radius - up * up));
    const bool is_right = curve.quadrant == 0 || curve.quadrant == 3;
    return is_right ? T(own.centre().x + out) : T(own.centre().x - out);
  }

  const CurveCycles<T>& cycles_;
  const Arithmetic<T>& in_;
};

}  // namespace minkref::inline disc
