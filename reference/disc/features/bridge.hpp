// Bridges: the chords of the empty discs between two features of P (Behar & Lien 2012, Sec. 8.2).
#pragma once

#include <type_traits>
#include <vector>

#include "reference/disc/index/corner_place.hpp"
#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// From the nearest point on a half's own feature to the one across.
template <class N>
struct Chord {
  Vector<N> from, to;
};

/// Some events' radius, by number, or any radius, by the square within the curves' frame.
struct BridgeRadius {
  std::uint32_t number;  ///< as DiscIndex counts; none: `squared` tells it
  Rational squared;
  TwoDoubles near;  ///< within `off`
  double off;

  bool is_of_events() const { return number != DiagramGraph::none; }
};

/// The diagram's places at a radius, part by part, and P's nearest points. Exact as roots
/// (RootNumber at given radii, Surd at all); quicker as intervals.
class Bridges {
 public:
  /// `index` must outlive it. O(n).
  explicit Bridges(const DiscIndex& index);

  const DiscIndex& index() const { return index_; }
  /// `number`: events' radius, or infinity.
  BridgeRadius of_events(std::uint32_t number) const;
  BridgeRadius of_square(const Rational& squared_radius) const;

  /// The bridge on a half reaching or crossing the radius. Within the frame.
  template <class N>
  Chord<N> chord(std::uint32_t half, const BridgeRadius& radius) const;
  /// The place with these nearest points, not at infinity.
  template <class N>
  Vector<N> place(std::uint32_t half, const BridgeRadius& radius) const;

 private:
  struct SiteInIntervals {
    bool is_point;
    Vector<Interval> point, normal;
    Interval level, inverse;  ///< of a line; of its squared length
  };
  template <class N>
  Vector<N> foot(std::uint32_t feature, const Vector<N>& place) const;
  bool is_flat(std::uint32_t half) const;
  template <class N>
  Equidistant<N> at_event(std::uint32_t event) const;

  const DiscIndex& index_;
  std::vector<SiteInIntervals> sites_;
};

}  // namespace minkref::inline disc
