// The paper's way to two facets' events (Sec. 5.1, 5.2), with any arithmetic.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/plane/critical/scale_solve.hpp"
#include "reference/space/critical/facet_event.hpp"

namespace minkref::inline space {

/// A contact of one facet's corner with the other facet (5.1), or of a side of each (5.2).
template <class T>
struct PaperContact {
  ContactKind kind;
  /// Solutions of the equation systems for s - 1: two for a corner (a system for each of its
  /// sides), a single solution for two sides. Missing if a side's line runs along the other plane,
  /// or never meets it.
  std::vector<ScaleSolution<T>> solutions{};
  std::optional<T> scale{};  ///< of the event, if any
};

/// The events of two facets that are not parallel. `printed` follows the text sentence by sentence:
/// x(1) and x(2), where a side's line meets the other facet's plane; sigma = x(2) - x(1); x(s) =
/// x(1) + (s - 1) sigma, set equal to an end of the side, or to the point where the line of a side
/// of the other facet meets the first plane. Each gives three equations for s, and all must agree.
/// `corrected` has one equation: the corner lies on the plane, or the sides share a plane. It also
/// finds events of a side along the other plane, which holds the side at one scale. Contacts always
/// come in the same order, so that answers of two arithmetics can be compared. Throws UndecidedSign
/// where T cannot tell.
template <class T>
class FacetContacts {
 public:
  using Vector = Eigen::Matrix<T, 3, 1>;
  /// The corner p s + q.
  struct Corner {
    Vector p, q;
  };
  using Facet = std::vector<Corner>;

  FacetContacts(const Facet& first, const Facet& second, Form form)
      : facets_{&first, &second}, form_(form) {}

  std::vector<PaperContact<T>> all() const {
    std::vector<PaperContact<T>> found;
    const bool printed = form_ == Form::printed;
    for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
      for (std::size_t k = 0; k < size(which); ++k) {
        found.push_back(printed ? printed_corner(which, k) : corrected_corner(which, k));
      }
    }
    for (std::size_t k = 0; k < size(0); ++k) {
      for (std::size_t l = 0; l < size(1); ++l) {
        found.push_back(printed ? printed_crossing(k, l) : corrected_crossing(k, l));
      }
    }
    return found;
  }

 private:
  /// x(1) and sigma.
  struct Track {
    Vector start, sigma;
    Vector at(const T& s) const { return start + sigma * T(s - T(1)); }
  };

  std::size_t size(std::size_t which) const { return facets_[which]->size(); }

  Vector corner(std::size_t which, std::size_t k, const T& s) const {
    const Facet& facet = *facets_[which];
    const Corner& c = facet[k % facet.size()];
    return c.q + c.p * s;
  }

  /// The point where a side's line meets the other facet's plane, by the equation of 5.2.
  std::optional<Vector> hit(std::size_t which, std::size_t k, const T& s) const {
    const Vector a = corner(which, k, s), b = corner(which, k + 1, s);
    const std::size_t other = 1 - which;
    const Vector ta = corner(other, 0, s), u = corner(other, 1, s) - ta,
                 v = corner(other, 2, s) - ta, e = a - b, d = a - ta;
    const T determinant = e.dot(u.cross(v));
    if (sign(determinant) == 0) return std::nullopt;  // singular: a line along the plane
    const T t = T(d.dot(u.cross(v))) / determinant;
    return Vector(a + (b - a) * t);
  }

  std::optional<Track> track(std::size_t which, std::size_t k) const {
    const auto one = hit(which, k, T(1)), two = hit(which, k, T(2));
    if (!one || !two) return std::nullopt;
    return Track{*one, *two - *one};
  }

  /// The contact of the corner, from the sides before and after the corner.
  PaperContact<T> printed_corner(std::size_t which, std::size_t k) const {
    PaperContact<T> contact{ContactKind::vertex};
    const Vector &p = (*facets_[which])[k].p, start = corner(which, k, T(1));
    for (const std::size_t side : {(k + size(which) - 1) % size(which), k}) {
      const auto x = track(which, side);
      if (!x) continue;
      contact.solutions.push_back(solve_by_consistency<T, 3>(x->sigma - p, start - x->start));
      const auto s = positive(contact.solutions.back());
      if (s && !contact.scale && is_inside(1 - which, x->at(*s), *s)) contact.scale = s;
    }
    return contact;
  }

  PaperContact<T> printed_crossing(std::size_t k, std::size_t l) const {
    PaperContact<T> contact{ContactKind::edge};
    const auto x1 = track(0, k), x2 = track(1, l);
    if (!x1 || !x2) return contact;
    contact.solutions.push_back(
        solve_by_consistency<T, 3>(x1->sigma - x2->sigma, x2->start - x1->start));
    const auto s = positive(contact.solutions.back());
    if (s && is_between(0, k, x1->at(*s), *s) && is_between(1, l, x1->at(*s), *s)) {
      contact.scale = s;
    }
    return contact;
  }

  PaperContact<T> corrected_corner(std::size_t which, std::size_t k) const {
    PaperContact<T> contact{ContactKind::vertex};
    const auto s =
        add_solution(contact, normal(1 - which), (*facets_[which])[k], (*facets_[1 - which])[0]);
    if (s && is_inside(1 - which, corner(which, k, *s), *s)) contact.scale = s;
    return contact;
  }

  PaperContact<T> corrected_crossing(std::size_t k, std::size_t l) const {
    PaperContact<T> contact{ContactKind::edge};
    const Vector u = corner(0, k + 1, T(1)) - corner(0, k, T(1)),
                 v = corner(1, l + 1, T(1)) - corner(1, l, T(1)), n = u.cross(v);
    const auto s = add_solution(contact, n, (*facets_[0])[k], (*facets_[1])[l]);
    if (!s) return contact;
    const Vector a = corner(0, k, *s), across = n.cross(v);
    const T way = T(Vector(corner(1, l, *s) - a).dot(across)) / T(u.dot(across));
    const Vector x = a + u * way;
    if (is_between(0, k, x, *s) && is_between(1, l, x, *s)) contact.scale = s;
    return contact;
  }

  /// The scale at which two corners are level along n: (s - 1) n . (p' - p) = n . (x - x').
  std::optional<T> add_solution(PaperContact<T>& contact, const Vector& n, const Corner& from,
                                const Corner& to) const {
    const T slope = n.dot(Vector(to.p - from.p)),
            height = n.dot(Vector(Vector(from.p + from.q) - Vector(to.p + to.q)));
    ScaleSolution<T> solution{};
    if (sign(slope) != 0) {
      solution = {Solution::root, T(height / slope)};
    } else if (sign(height) == 0) {
      solution.kind = Solution::identity;
    }
    contact.solutions.push_back(solution);
    return positive(solution);
  }

  static std::optional<T> positive(const ScaleSolution<T>& solution) {
    if (solution.kind != Solution::root) return std::nullopt;
    const T s = solution.scale + T(1);
    if (sign(s) <= 0) return std::nullopt;
    return s;
  }

  Vector normal(std::size_t which) const {
    const Vector a = corner(which, 0, T(1));
    return Vector(corner(which, 1, T(1)) - a).cross(Vector(corner(which, 2, T(1)) - a));
  }

  /// Whether a point of the facet's plane lies inside the facet.
  bool is_inside(std::size_t which, const Vector& x, const T& s) const {
    const Vector n = normal(which);
    for (std::size_t k = 0; k < size(which); ++k) {
      const Vector a = corner(which, k, s), side = corner(which, k + 1, s) - a;
      if (sign(T(n.cross(side).dot(Vector(x - a)))) < 0) return false;
    }
    return true;
  }

  /// Whether a point of the line lies between the ends of the side.
  bool is_between(std::size_t which, std::size_t k, const Vector& x, const T& s) const {
    const Vector a = corner(which, k, s), b = corner(which, k + 1, s), side = b - a;
    return sign(T(side.dot(Vector(x - a)))) >= 0 && sign(T(side.dot(Vector(b - x)))) >= 0;
  }

  std::array<const Facet*, 2> facets_;
  Form form_;
};

}  // namespace minkref::inline space
