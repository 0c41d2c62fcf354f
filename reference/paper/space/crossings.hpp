// Crossings between two facets of the convolution: a side pierces a facet, between two scales
// (Behar & Lien 2012, Sec. 5.1, 5.2), each sentence as read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "reference/paper/space/facet_contacts.hpp"
#include "reference/paper/space/update_readings.hpp"

namespace minkref::inline space {

/// A node for the arrangements on two facets, with a closed interval of scales s > 0; no bound
/// means down to 0 or up to infinity.
template <class T>
struct Crossing {
  /// A side piercing the second or the first facet; two facets coplanar at a single scale; two
  /// sides, for always coplanar facets.
  enum class Kind : std::uint8_t { side_of_first, side_of_second, at_one_scale, in_plane };

  bool is_point() const { return kind == Kind::side_of_first || kind == Kind::side_of_second; }
  /// For a point: the facet with the side, and the pierced facet.
  std::uint32_t owner() const { return kind == Kind::side_of_first ? first : second; }
  std::uint32_t other() const { return kind == Kind::side_of_first ? second : first; }

  std::uint32_t first = 0, second = 0;  ///< facets, ascending
  Kind kind = Kind::side_of_first;
  std::uint8_t side = 0;        ///< of the owner; in a plane, of the first facet
  std::uint8_t other_side = 0;  ///< in a plane, of the second
  std::optional<T> lower, upper;
  typename TwoFacets<T>::Track x = TwoFacets<T>::Track::none();  ///< x0 + (s - 1) sigma of a point
};

/// Facts from two facets' directions, the same at all scales.
struct PairDirections {
  bool parallel = false, coplanar = false;           ///< the facets; in one plane at all scales
  std::array<std::array<bool, 4>, 2> along_plane{};  ///< side k of each along the other's plane
};

namespace detail {

/// slope s + value >= 0: a point is on the inner side of an end or a side.
template <class T>
struct Condition {
  T slope, value;
};

/// Narrows the scales for one point, condition by condition.
template <class T>
class CrossingBounds {
 public:
  explicit CrossingBounds(SpaceUpdateReadings::Bounds reading)
      : joint_(reading == SpaceUpdateReadings::Bounds::joint) {}

  /// `solution`: the scale at which the condition is zero, as read; `is_constant`: without a root
  /// the condition keeps its sign, which an overdetermined system does not tell; `check(s)`:
  /// whether the point is where the event asks for it. Returns whether scales may be left.
  template <class Check>
  bool take(const Condition<T>& condition, const ScaleSolution<T>& solution, bool is_constant,
            Check&& check) {
    const int at_one = sign(T(condition.slope + condition.value)), rising = sign(condition.slope);
    at_one_ = at_one_ && (at_one >= 0 || solution.kind == Solution::identity);
    if (solution.kind != Solution::root) {
      const bool bounds =
          joint_ && solution.kind == Solution::inconsistent && (is_constant || rising == 0);
      return !bounds || at_one >= 0;
    }
    if (rising == 0) return true;
    if (!joint_ && (sign(solution.scale) <= 0 || !check(solution.scale))) return true;
    auto& bound = rising > 0 ? lower : upper;
    const int order = bound ? sign(T(solution.scale - *bound)) : rising;
    if (order * rising > 0) bound = solution.scale;
    return !upper || (sign(*upper) > 0 && (!lower || sign(T(*lower - *upper)) <= 0));
  }

  /// Cuts the scales to s > 0; false if none is left. Without any bound the conditions hold at all
  /// scales if at 1.
  bool finish() {
    if (!lower && !upper) return at_one_;
    if (lower && sign(*lower) <= 0) lower.reset();
    return true;
  }

  std::optional<T> lower, upper;

 private:
  bool joint_;
  bool at_one_ = true;
};

}  // namespace detail

/// The crossings of two facets, as read. Throws UndecidedSign where T cannot tell.
template <class T>
class PairCrossings {
 public:
  using Pair = TwoFacets<T>;
  using Vector = typename Pair::Vector;
  using Facet = typename Pair::Facet;
  using Track = typename Pair::Track;
  using Kind = typename Crossing<T>::Kind;

  /// `directions`, unless null, is taken instead of the arithmetic's determinants. `zero`: the
  /// tolerance below which numbers count as zero. All must outlive it.
  PairCrossings(const Facet& first, const Facet& second, const PairDirections* directions,
                const SpaceUpdateReadings& readings, const T& zero)
      : pair_(first, second),
        directions_(directions),
        readings_(readings),
        zero_(zero),
        systems_(pair_, readings_.events, zero_) {}
  PairCrossings(const PairCrossings&) = delete;
  PairCrossings& operator=(const PairCrossings&) = delete;

  /// Calls add(Crossing) for each, without the facets' numbers; returns whether the facets share a
  /// plane at all scales. A side with an end at a corner of the other facet has no crossing: that
  /// corner is both facets' at all scales. O(1).
  template <class Add>
  bool find(Add&& add) {
    const FacetReadings& events = readings_.events;
    if (directions_ ? directions_->parallel : pair_.are_parallel()) {
      if (directions_ ? directions_->coplanar : pair_.are_coplanar()) {
        if (events.coplanar != FacetReadings::Coplanar::left_out) add_in_plane(add);
        return true;
      }
      if (events.parallel != FacetReadings::Parallel::left_out) add_at_one_scale(add);
      return false;
    }
    if (events.crossing == FacetReadings::Crossing::points) find_tracks();
    normals_ = {pair_.normal(0), pair_.normal(1)};
    for (const std::size_t which : {0U, 1U}) {
      for (std::size_t k = 0; k < pair_.size(which); ++k) {
        if (!ends_at_a_corner(which, k)) add_side(which, k, add);
      }
    }
    return false;
  }

 private:
  void find_tracks() {
    for (const std::size_t which : {0U, 1U}) {
      for (std::size_t k = 0; k < pair_.size(which); ++k) {
        tracks_[which][k] = track(which, k);
      }
    }
  }

  std::optional<Track> track(std::size_t which, std::size_t k) const {
    if (directions_ && directions_->along_plane[which][k]) return std::nullopt;
    return pair_.track(which, k);
  }

  bool ends_at_a_corner(std::size_t which, std::size_t k) const {
    for (const std::size_t end : {k, k + 1}) {
      const auto& own = pair_.named(which, end);
      for (std::size_t j = 0; j < pair_.size(1 - which); ++j) {
        const auto& corner = pair_.named(1 - which, j);
        if (own.of_P == corner.of_P && own.of_Q == corner.of_Q) return true;
      }
    }
    return false;
  }

  template <class Add>
  void add_side(std::size_t which, std::size_t k, Add&& add) {
    const bool kept = readings_.events.crossing == FacetReadings::Crossing::points;
    auto x = kept ? tracks_[which][k] : track(which, k);
    if (!x) return;  // singular: the side runs along the other plane
    detail::CrossingBounds<T> bounds(readings_.bounds);
    if (!take_ends(which, k, *x, bounds) || !take_sides(which, k, *x, bounds)) return;
    if (!bounds.finish()) return;
    Crossing<T> found;
    found.kind = which == 0 ? Kind::side_of_first : Kind::side_of_second;
    found.side = static_cast<std::uint8_t>(k);
    found.lower = std::move(bounds.lower);
    found.upper = std::move(bounds.upper);
    found.x = std::move(*x);
    add(std::move(found));
  }

  /// Vertex events: the point reaches an end of the side (5.1).
  bool take_ends(std::size_t which, std::size_t k, const Track& x,
                 detail::CrossingBounds<T>& bounds) const {
    const Vector along = pair_.side(which, k, T(1)), base = x.x0 - x.sigma;
    const bool by_lines = readings_.events.corner == FacetReadings::Corner::lines;
    for (const std::size_t end : {0U, 1U}) {
      const auto& own = pair_.named(which, k + end);
      detail::Condition<T> inside{T(along.dot(Vector(x.sigma - own.p))),
                                  T(along.dot(Vector(base - own.q)))};
      if (end == 1) inside = {T(-inside.slope), T(-inside.value)};
      const auto solution = by_lines ? systems_.corner_on_track(which, k, k + end, x)
                                     : systems_.corner_on_plane(which, k + end);
      if (!bounds.take(inside, solution, !by_lines || never_overdetermined(),
                       [&](const T& s) { return pair_.is_inside(1 - which, x.at(s), s); })) {
        return false;
      }
    }
    return true;
  }

  /// Edge events: the point reaches a side of the pierced facet (5.2).
  bool take_sides(std::size_t which, std::size_t k, const Track& x,
                  detail::CrossingBounds<T>& bounds) const {
    const std::size_t other = 1 - which;
    const Vector base = x.x0 - x.sigma;
    const bool by_lines = readings_.events.crossing == FacetReadings::Crossing::determinant;
    for (std::size_t l = 0; l < pair_.size(other); ++l) {
      const auto& from = pair_.named(other, l);
      const Vector inwards = normals_[other].cross(pair_.side(other, l, T(1)));
      const detail::Condition<T> inside{T(inwards.dot(Vector(x.sigma - from.p))),
                                        T(inwards.dot(Vector(base - from.q)))};
      if (!bounds.take(inside, side_event(which, k, l, x),
                       by_lines || (tracks_[other][l] && never_overdetermined()), [&](const T& s) {
                         return readings_.events.ends == FacetReadings::Ends::lines ||
                                (pair_.is_between(which, k, x.at(s), s) &&
                                 pair_.is_between(other, l, x.at(s), s));
                       })) {
        return false;
      }
    }
    return true;
  }

  bool never_overdetermined() const {
    return readings_.events.solve == Readings::Solve::corrected ||
           readings_.events.solve == Readings::Solve::least_squares;
  }

  ScaleSolution<T> side_event(std::size_t which, std::size_t k, std::size_t l,
                              const Track& x) const {
    if (readings_.events.crossing == FacetReadings::Crossing::determinant) {
      return which == 0 ? systems_.lines_meet(k, l) : systems_.lines_meet(l, k);
    }
    const auto& other = tracks_[1 - which][l];
    if (!other) return {};  // its system is singular
    return which == 0 ? systems_.points_meet(x, *other) : systems_.points_meet(*other, x);
  }

  /// "The scale value when the faces are coplanar", if corners or sides meet there.
  template <class Add>
  void add_at_one_scale(Add&& add) const {
    if (directions_) {  // the arithmetic would have to see that they are parallel
      const auto level = systems_.corner_on_plane(0, 0);
      if (readings_.events.corner == FacetReadings::Corner::lines) return;  // singular
      if (level.kind == Solution::root && sign(level.scale) > 0) add(at_one_scale(level.scale));
      return;
    }
    const FacetContacts<T> contacts(pair_.facet(0), pair_.facet(1), readings_.events, zero_);
    for (const auto& contact : contacts.all()) {
      if (!contact.scale) continue;
      add(at_one_scale(*contact.scale));
      return;
    }
  }

  static Crossing<T> at_one_scale(const T& scale) {
    Crossing<T> found;
    found.kind = Kind::at_one_scale;
    found.lower = found.upper = scale;
    return found;
  }

  /// "The logic from the 2D scaling".
  template <class Add>
  void add_in_plane(Add&& add) const {
    const CoplanarSides<T> sides(pair_, readings_.events, zero_);
    for (std::size_t k = 0; k < pair_.size(0); ++k) {
      for (std::size_t l = 0; l < pair_.size(1); ++l) {
        auto region = sides.region(k, l);
        if (!region) continue;
        Crossing<T> found;
        found.kind = Kind::in_plane;
        found.side = static_cast<std::uint8_t>(k);
        found.other_side = static_cast<std::uint8_t>(l);
        found.lower = std::move(region->lower);
        found.upper = std::move(region->upper);
        add(std::move(found));
      }
    }
  }

  const Pair pair_;
  const PairDirections* const directions_;
  const SpaceUpdateReadings& readings_;
  const T& zero_;
  const FacetSystems<T> systems_;
  std::array<Vector, 2> normals_;
  std::array<std::array<std::optional<Track>, 4>, 2> tracks_;
};

}  // namespace minkref::inline space
