// An interior point of an arrangement's face.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

namespace detail {

/// The least parameter r > 0 at which the ray m + r n meets the segment a b, none if it misses it.
template <class T, class V>
std::optional<T> ray_hit(const V& m, const V& n, const V& a, const V& b) {
  const V d(b - a), w(a - m);
  const T det = n.x() * d.y() - n.y() * d.x();
  const T off = w.x() * n.y() - w.y() * n.x();
  if (sign(det) == 0) {
    if (sign(off) != 0) return std::nullopt;
    // The segment lies on the line of the ray.
    const T square = n.x() * n.x() + n.y() * n.y();
    const V u(b - m);
    const T ra = T(w.x() * n.x() + w.y() * n.y()) / square;
    const T rb = T(u.x() * n.x() + u.y() * n.y()) / square;
    if (sign(ra) <= 0 || sign(rb) <= 0) return std::nullopt;
    return sign(T(ra - rb)) < 0 ? ra : rb;
  }
  const T along = off / det;
  if (sign(along) < 0 || sign(T(along - T(1))) > 0) return std::nullopt;
  const T hit = T(w.x() * d.y() - w.y() * d.x()) / det;
  if (sign(hit) <= 0) return std::nullopt;
  return hit;
}

/// The middle of the ray from the middle of half-edge h into its face, up to the first hit.
/// `position` gives a node's coordinates as vectors V over T. If T is a field, the point is
/// certainly interior.
template <class T, class V, class K, class Position>
V middle_of_face(const Arrangement<K>& arrangement, std::uint32_t face, std::uint32_t h,
                 Position&& position) {
  const T half = T(1) / T(2);
  const V a = position(arrangement.origin(h)), b = position(arrangement.target(h));
  const V m((a + b) * half), n(T(a.y() - b.y()), T(b.x() - a.x()));
  std::optional<T> nearest;
  arrangement.for_each_half_edge(face, [&](std::uint32_t g) {
    if (g == h) return;
    const auto hit =
        ray_hit<T, V>(m, n, position(arrangement.origin(g)), position(arrangement.target(g)));
    if (hit && (!nearest || sign(T(*hit - *nearest)) < 0)) nearest = hit;
  });
  const T r = nearest ? T(*nearest * half) : T(1);
  return V(m + n * r);
}

/// Whether the point certainly lies inside the face: crossings of a ray to the left, each certain
/// despite the error of the nodes' doubles.
template <class Grid>
bool certainly_inside(const Arrangement<GridKernel<Grid>>& arrangement, std::uint32_t face,
                      double x, double y, double error) {
  bool inside = false, certain = true;
  arrangement.for_each_half_edge(face, [&](std::uint32_t h) {
    const auto& a = arrangement.node(arrangement.origin(h));
    const auto& b = arrangement.node(arrangement.target(h));
    if (std::abs(a.y - y) <= 2 * error || std::abs(b.y - y) <= 2 * error) {
      // A height too near to call matters only if the edge may reach the ray.
      if (std::min(a.x, b.x) > x + 2 * error) return;
      if (std::min(a.y, b.y) > y + 2 * error || std::max(a.y, b.y) < y - 2 * error) return;
      certain = false;
      return;
    }
    if ((a.y > y) == (b.y > y)) return;
    const double left = (b.x - a.x) * (y - a.y), right = (b.y - a.y) * (x - a.x);
    const double bound =
        (std::abs(left) + std::abs(right)) * filter_bound +
        4 * error *
            (std::abs(b.x - a.x) + std::abs(b.y - a.y) + std::abs(y - a.y) + std::abs(x - a.x)) +
        16 * error * error;
    if (std::abs(left - right) <= bound) {
      certain = false;
      return;
    }
    const bool left_of_edge = left - right > 0;
    if (b.y > a.y ? !left_of_edge : left_of_edge) inside = !inside;
  });
  return certain && inside;
}

}  // namespace detail

/// A bounded face's interior point as two doubles, certified; none if doubles are too coarse.
template <class Grid>
std::optional<typename GridKernel<Grid>::Query> interior_point_in_doubles(
    const GridKernel<Grid>& kernel, const Arrangement<GridKernel<Grid>>& arrangement,
    std::uint32_t face) {
  const auto position = [&](std::uint32_t n) {
    return Vector2<double>(arrangement.node(n).x, arrangement.node(n).y);
  };
  // Longer edges promise wider faces: try the longest few.
  std::vector<std::pair<double, std::uint32_t>> candidates;
  arrangement.for_each_half_edge(face, [&](std::uint32_t h) {
    const Vector2<double> d(position(arrangement.target(h)) - position(arrangement.origin(h)));
    candidates.emplace_back(-(d.x() * d.x() + d.y() * d.y()), h);
  });
  std::sort(candidates.begin(), candidates.end());
  if (candidates.size() > 4) candidates.resize(4);
  for (const auto& [negated, h] : candidates) {
    if (negated == 0) break;  // shorter than doubles tell: no normal to follow
    const auto x = detail::middle_of_face<double, Vector2<double>>(arrangement, face, h, position);
    if (detail::certainly_inside(arrangement, face, x.x(), x.y(), kernel.node_error)) {
      return typename GridKernel<Grid>::Query{x.x(), x.y()};
    }
  }
  return std::nullopt;
}

/// A bounded face's interior point with rational coordinates. Exact.
template <class Grid>
Point exact_interior_point(const GridKernel<Grid>&,
                           const Arrangement<GridKernel<Grid>>& arrangement, std::uint32_t face) {
  const auto position = [&](std::uint32_t n) {
    return Vector2<Rational>(GridKernel<Grid>::exact(arrangement.node(n), 0),
                             GridKernel<Grid>::exact(arrangement.node(n), 1));
  };
  const auto x = detail::middle_of_face<Rational, Vector2<Rational>>(
      arrangement, face, arrangement.cycles(face).front(), position);
  return {x.x(), x.y()};
}

/// An interior point over one scalar type, as exact as T.
template <class T>
Vector2<T> interior_point(const PlainKernel<T>&, const Arrangement<PlainKernel<T>>& arrangement,
                          std::uint32_t face) {
  return detail::middle_of_face<T, Vector2<T>>(
      arrangement, face, arrangement.cycles(face).front(),
      [&](std::uint32_t n) { return arrangement.node(n); });
}

}  // namespace minkref::inline plane
