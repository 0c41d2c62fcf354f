// Two facets of the convolution at all scales, with one arithmetic: the questions Sec. 5 asks about
// them.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/number/eigen.hpp"

namespace minkref::inline space {

/// Two facets, `0` and `1`, with corners s p + q. Throws UndecidedSign where T cannot tell.
template <class T>
class TwoFacets {
 public:
  using Vector = Eigen::Matrix<T, 3, 1>;
  using Matrix = Eigen::Matrix<T, 3, 3>;
  /// The corner s p + q, and its vertices of P and Q.
  struct Corner {
    Vector p, q;
    std::uint32_t of_P, of_Q;
  };
  using Facet = std::vector<Corner>;

  /// Both must outlive the pair.
  TwoFacets(const Facet& first, const Facet& second) : facets_{&first, &second} {}

  std::size_t size(std::size_t which) const { return facets_[which]->size(); }

  const Facet& facet(std::size_t which) const { return *facets_[which]; }

  const Corner& named(std::size_t which, std::size_t k) const {
    const Facet& facet = *facets_[which];
    return facet[k % facet.size()];
  }

  Vector corner(std::size_t which, std::size_t k, const T& s) const {
    const Corner& c = named(which, k);
    return c.q + c.p * s;
  }

  /// The side from a corner to the next; its direction is the same at all scales.
  Vector side(std::size_t which, std::size_t k, const T& s) const {
    return corner(which, k + 1, s) - corner(which, k, s);
  }

  Vector normal(std::size_t which) const {
    const Vector a = corner(which, 0, T(1));
    return Vector(corner(which, 1, T(1)) - a).cross(Vector(corner(which, 2, T(1)) - a));
  }

  bool are_parallel() const { return is_zero(normal(0).cross(normal(1))); }

  /// Whether two parallel facets share their plane at all scales.
  bool are_coplanar() const {
    const Vector n = normal(1);
    const Corner &a = named(0, 0), &b = named(1, 0);
    return sign(T(n.dot(Vector(a.p - b.p)))) == 0 && sign(T(n.dot(Vector(a.q - b.q)))) == 0;
  }

  bool is_parallel_to_side(std::size_t k, std::size_t l) const {
    return is_zero(side(0, k, T(1)).cross(side(1, l, T(1))));
  }

  /// The point at which a side's line meets the other facet's plane, by the system of Sec. 5.2:
  /// e_a - t_a = M^T (t, u, v), where M has the rows e_a - e_b, t_b - t_a and t_c - t_a. Nothing if
  /// singular: then the line runs along the plane.
  std::optional<Vector> crossing(std::size_t which, std::size_t k, const T& s) const {
    const std::size_t other = 1 - which;
    const Vector a = corner(which, k, s), b = corner(which, k + 1, s), ta = corner(other, 0, s);
    Matrix rows;
    rows.row(0) = Vector(a - b).transpose();
    rows.row(1) = Vector(corner(other, 1, s) - ta).transpose();
    rows.row(2) = Vector(corner(other, 2, s) - ta).transpose();
    const Matrix system = rows.transpose();
    if (sign(T(system.determinant())) == 0) return std::nullopt;
    const Vector tuv = system.inverse() * Vector(a - ta);
    return Vector(a + Vector(b - a) * tuv[0]);
  }

  /// x(s) = x0 + (s - 1) sigma, from x(1) and x(2).
  struct Track {
    Vector x0, sigma;
    Vector at(const T& s) const { return x0 + sigma * T(s - T(1)); }
    static Track none() { return {Vector(T(0), T(0), T(0)), Vector(T(0), T(0), T(0))}; }
  };
  std::optional<Track> track(std::size_t which, std::size_t k) const {
    const auto one = crossing(which, k, T(1)), two = crossing(which, k, T(2));
    if (!one || !two) return std::nullopt;
    return Track{*one, *two - *one};
  }

  /// Whether a point of the facet's plane lies inside the facet.
  bool is_inside(std::size_t which, const Vector& x, const T& s) const {
    const Vector n = normal(which);
    for (std::size_t k = 0; k < size(which); ++k) {
      const Vector from = x - corner(which, k, s);
      if (sign(T(n.cross(side(which, k, s)).dot(from))) < 0) return false;
    }
    return true;
  }

  /// Whether a point of the line lies between the ends of the side.
  bool is_between(std::size_t which, std::size_t k, const Vector& x, const T& s) const {
    const Vector a = corner(which, k, s), b = corner(which, k + 1, s), along = b - a;
    return sign(T(along.dot(Vector(x - a)))) >= 0 && sign(T(along.dot(Vector(b - x)))) >= 0;
  }

  /// Whether two sides, coplanar at a scale and not parallel, cross.
  bool sides_cross(std::size_t k, std::size_t l, const T& s) const {
    if (is_parallel_to_side(k, l)) return false;
    const Vector n = normal(0);
    const auto parts = [&](std::size_t own, std::size_t i, std::size_t j) {
      const Vector from = corner(own, i, s), across = n.cross(side(own, i, s));
      const auto where = [&](std::size_t end) {
        return sign(T(across.dot(Vector(corner(1 - own, end, s) - from))));
      };
      return where(j) * where(j + 1) <= 0;
    };
    return parts(0, k, l) && parts(1, l, k);
  }

 private:
  static bool is_zero(const Vector& v) {
    return sign(v[0]) == 0 && sign(v[1]) == 0 && sign(v[2]) == 0;
  }

  std::array<const Facet*, 2> facets_;
};

}  // namespace minkref::inline space
