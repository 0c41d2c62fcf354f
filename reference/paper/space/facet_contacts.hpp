// The paper's way to two facets' events (Sec. 5.1, 5.2), each sentence as read, with any
// arithmetic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "reference/paper/space/coplanar_sides.hpp"
#include "reference/paper/space/facet_readings.hpp"
#include "reference/paper/space/facet_systems.hpp"
#include "reference/paper/space/two_facets.hpp"
#include "reference/plane/critical/scale_solve.hpp"
#include "reference/space/critical/facet_event.hpp"

namespace minkref::inline space {

/// Why a side's line has no point on the other facet's plane: the matrix of Sec. 5.2 is singular.
/// "Parallel faces" are the case that the paper names.
enum class Singular : std::uint8_t { no, parallel_faces, parallel_sides, side_along_plane };

/// A contact between one facet's corner and the other facet (5.1), or between a side of each (5.2).
template <class T>
struct PaperContact {
  ContactKind kind = ContactKind::vertex;
  Singular singular = Singular::no;
  std::vector<ScaleSolution<T>> solutions{};  ///< of the systems for s that were set up
  std::optional<T> scale{};                   ///< of the event, if any
};

/// The events of two facets. As printed, the text sentence by sentence: x(1) and x(2), where a
/// side's line meets the other facet's plane, by the matrix of 5.2; sigma = x(2) - x(1); x(s) =
/// x(1) + (s - 1) sigma, set equal to an end of the side, or to the point where the line of a side
/// of the other facet meets the first plane; parallel faces at the scale that makes them coplanar,
/// and always coplanar ones by the way of the plane. With all readings corrected and exact numbers
/// these are the exact events. Throws UndecidedSign where T cannot tell.
template <class T>
class FacetContacts {
 public:
  using Pair = TwoFacets<T>;
  using Vector = typename Pair::Vector;
  using Facet = typename Pair::Facet;

  /// `zero`: the tolerance below which numbers count as zero. All must outlive it.
  FacetContacts(const Facet& first, const Facet& second, const FacetReadings& readings,
                const T& zero)
      : pair_(first, second), readings_(readings), zero_(zero), systems_(pair_, readings_, zero_) {}
  FacetContacts(const FacetContacts&) = delete;
  FacetContacts& operator=(const FacetContacts&) = delete;

  /// Always keeps the same order, to compare the answers of two arithmetics: each corner, each side
  /// of the first with each side of the second, then the same pairs again for the second scale of
  /// coplanar sides. O(1) for triangles and parallelograms.
  std::vector<PaperContact<T>> all() const {
    const std::size_t corners = pair_.size(0) + pair_.size(1),
                      crossings = pair_.size(0) * pair_.size(1);
    std::vector<PaperContact<T>> found(corners + 2 * crossings);
    const bool parallel = pair_.are_parallel();
    if (parallel && pair_.are_coplanar()) {
      if (readings_.coplanar != FacetReadings::Coplanar::left_out) add_in_plane(found);
      return found;
    }
    if (parallel && readings_.parallel == FacetReadings::Parallel::left_out) return found;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t which = i < pair_.size(0) ? 0 : 1;
      found[i] = corner_contact(which, i - which * pair_.size(0), parallel);
    }
    if (parallel) {
      add_at_one_scale(found);
      return found;
    }
    each_crossing([&](std::size_t k, std::size_t l, std::size_t i) {
      found[corners + i] = readings_.crossing == FacetReadings::Crossing::points ? points_meet(k, l)
                                                                                 : lines_meet(k, l);
    });
    return found;
  }

 private:
  template <class Use>
  void each_crossing(Use&& use) const {
    for (std::size_t k = 0; k < pair_.size(0); ++k) {
      for (std::size_t l = 0; l < pair_.size(1); ++l) use(k, l, k * pair_.size(1) + l);
    }
  }

  PaperContact<T> corner_contact(std::size_t which, std::size_t k, bool parallel) const {
    if (readings_.corner == FacetReadings::Corner::lines) return by_lines(which, k, parallel);
    PaperContact<T> contact{ContactKind::vertex};
    const auto s = add(contact, systems_.corner_on_plane(which, k));
    if (s && pair_.is_inside(1 - which, pair_.corner(which, k, *s), *s)) contact.scale = s;
    return contact;
  }

  /// x(s) = e_i(s) for the sides before and after the corner (5.1).
  PaperContact<T> by_lines(std::size_t which, std::size_t k, bool parallel) const {
    PaperContact<T> contact{ContactKind::vertex};
    for (const std::size_t side : {(k + pair_.size(which) - 1) % pair_.size(which), k}) {
      const auto x = pair_.track(which, side);
      if (!x) continue;
      const auto s = add(contact, systems_.corner_on_track(which, side, k, *x));
      if (s && !contact.scale && pair_.is_inside(1 - which, x->at(*s), *s)) contact.scale = s;
    }
    if (contact.solutions.empty()) {
      contact.singular = parallel ? Singular::parallel_faces : Singular::side_along_plane;
    }
    return contact;
  }

  /// x1(s) = x2(s) (5.2).
  PaperContact<T> points_meet(std::size_t k, std::size_t l) const {
    PaperContact<T> contact{ContactKind::edge};
    const auto x1 = pair_.track(0, k), x2 = pair_.track(1, l);
    if (!x1 || !x2) {
      contact.singular =
          pair_.is_parallel_to_side(k, l) ? Singular::parallel_sides : Singular::side_along_plane;
      return contact;
    }
    const auto s = add(contact, systems_.points_meet(*x1, *x2));
    if (s) keep_within(contact, k, l, x1->at(*s), *s);
    return contact;
  }

  /// The determinant of both sides and the way between them is zero: linear in s.
  PaperContact<T> lines_meet(std::size_t k, std::size_t l) const {
    PaperContact<T> contact{ContactKind::edge};
    const auto s = add(contact, systems_.lines_meet(k, l));
    if (!s) return contact;
    const Vector u = pair_.side(0, k, T(1)), v = pair_.side(1, l, T(1));
    const Vector from = pair_.corner(0, k, *s), across = u.cross(v).cross(v);
    const T along = T(u.dot(across));
    if (sign(along) == 0) return contact;  // parallel sides
    const T way = T(Vector(pair_.corner(1, l, *s) - from).dot(across)) / along;
    keep_within(contact, k, l, Vector(from + u * way), *s);
    return contact;
  }

  void keep_within(PaperContact<T>& contact, std::size_t k, std::size_t l, const Vector& x,
                   const T& s) const {
    if (readings_.ends == FacetReadings::Ends::lines ||
        (pair_.is_between(0, k, x, s) && pair_.is_between(1, l, x, s))) {
      contact.scale = s;
    }
  }

  /// Parallel faces: "if there are no vertex events, we check for edge intersections", at the scale
  /// that the first corner has, whether or not it is inside the other face.
  void add_at_one_scale(std::vector<PaperContact<T>>& found) const {
    const std::size_t corners = pair_.size(0) + pair_.size(1);
    for (std::size_t i = 0; i < corners; ++i) {
      if (found[i].scale) return;
    }
    std::optional<T> s;
    for (const ScaleSolution<T>& solution : found[0].solutions) {
      if (!s) s = positive(solution);
    }
    each_crossing([&](std::size_t k, std::size_t l, std::size_t i) {
      PaperContact<T>& contact = found[corners + i];
      contact.kind = ContactKind::edge;
      if (!s) contact.singular = found[0].singular;
      if (s && pair_.sides_cross(k, l, *s)) contact.scale = s;
    });
  }

  /// Coplanar faces: where sides begin and cease to meet, as in the plane.
  void add_in_plane(std::vector<PaperContact<T>>& found) const {
    const CoplanarSides<T> sides(pair_, readings_, zero_);
    const std::size_t corners = pair_.size(0) + pair_.size(1),
                      crossings = pair_.size(0) * pair_.size(1);
    each_crossing([&](std::size_t k, std::size_t l, std::size_t i) {
      auto region = sides.region(k, l);
      if (!region) return;
      found[corners + i].scale = std::move(region->lower);
      found[corners + crossings + i].scale = std::move(region->upper);
    });
  }

  static std::optional<T> add(PaperContact<T>& contact, ScaleSolution<T> solution) {
    contact.solutions.push_back(std::move(solution));
    return positive(contact.solutions.back());
  }

  static std::optional<T> positive(const ScaleSolution<T>& solution) {
    if (solution.kind != Solution::root || sign(solution.scale) <= 0) return std::nullopt;
    return solution.scale;
  }

  const Pair pair_;
  const FacetReadings& readings_;
  const T& zero_;
  const FacetSystems<T> systems_;
};

}  // namespace minkref::inline space
