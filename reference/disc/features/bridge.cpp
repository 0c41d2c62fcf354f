#include "reference/disc/features/bridge.hpp"

namespace minkref::inline disc {

Bridges::Bridges(const DiscIndex& index) : index_(index) {
  const OffsetCurves& curves = index.diagram().curves;
  for (std::uint32_t k = 0; k < curves.features.size(); ++k) {
    const Site site = Site::of(curves, k);
    SiteInIntervals near{site.is_point, numbers<Interval>(site.point), {}, {}, {}};
    if (!site.is_point) {
      near.normal = numbers<Interval>(site.normal);
      near.level = Interval(site.level());
      near.inverse = Interval(Rational(1 / site.squared_length()));
    }
    sites_.push_back(near);
  }
}

BridgeRadius Bridges::of_events(std::uint32_t number) const {
  BridgeRadius radius{number, 0, {}, 0};
  if (number > index_.radii()) return radius;
  const Interval near = sqrt(index_.diagram().events[index_.event_at(number - 1)].squared_radius);
  radius.near.high = approximate(near);
  radius.off = near.upper() - near.lower();
  return radius;
}

BridgeRadius Bridges::of_square(const Rational& squared_radius) const {
  const FrameRadius radius = index_.in_frame(squared_radius);
  return {DiagramGraph::none, radius.squared, radius.near, radius.off};
}

template <class N>
Equidistant<N> Bridges::at_event(std::uint32_t event) const {
  const DiagramEvent& own = index_.diagram().events[event];
  if constexpr (std::is_same_v<N, Interval>) {
    return {own.at, own.squared_radius};
  } else {
    return equidistant_places<N>(index_.diagram().curves, own.of)[own.branch];
  }
}

template <class N>
Vector<N> Bridges::foot(std::uint32_t feature, const Vector<N>& place) const {
  if constexpr (std::is_same_v<N, Interval>) {
    const SiteInIntervals& site = sites_[feature];
    if (site.is_point) return site.point;
    return place - ((dot(site.normal, place) - site.level) * site.inverse) * site.normal;
  } else {
    const Site site = Site::of(index_.diagram().curves, feature);
    if (site.is_point) return numbers<N>(site.point);
    const Vector<N> normal = numbers<N>(site.normal);
    const N height =
        (dot(normal, place) - N(site.level())) * N(Rational(1 / site.squared_length()));
    return place - height * normal;
  }
}

/// Whether the half lies halfway between parallel edges, where all places have one radius.
bool Bridges::is_flat(std::uint32_t half) const {
  const DiagramHalf& own = index_.graph().halves[half];
  const std::uint32_t across = index_.graph().halves[own.twin].feature;
  const SiteInIntervals &a = sites_[own.feature], &b = sites_[across];
  if (a.is_point || b.is_point) return false;
  if (const auto certain = certified_sign(cross(a.normal, b.normal))) return *certain == 0;
  const OffsetCurves& curves = index_.diagram().curves;
  return cross(Site::of(curves, own.feature).normal, Site::of(curves, across).normal) == 0;
}

template <class N>
Vector<N> Bridges::place(std::uint32_t half, const BridgeRadius& radius) const {
  const DiagramGraph& graph = index_.graph();
  const DiagramHalf& own = graph.halves[half];
  const std::uint32_t high = index_.rises(half) ? own.to : own.from;
  const bool is_upper = radius.is_of_events() && index_.radius_number(high) == radius.number;
  if (is_upper || is_flat(half)) return at_event<N>(high).at;
  if constexpr (std::is_same_v<N, Interval>) {
    constexpr double sharp = 0x1p-40;
    const BoundedPoint near = index_.rounded_corner(half, radius.near, radius.off);
    if (near.error < sharp) {
      return {Interval(near.x - near.error, near.x + near.error),
              Interval(near.y - near.error, near.y + near.error)};
    }
  }
  const DiagramEvents& diagram = index_.diagram();
  const N squared = radius.is_of_events()
                        ? at_event<N>(index_.event_at(radius.number - 1)).squared_radius
                        : N(radius.squared);
  return corner_place<N>(Site::of(diagram.curves, own.feature),
                         Site::of(diagram.curves, graph.halves[own.twin].feature), squared,
                         [&](const Point& from, const Direction& along) {
                           return side_of_end(diagram, graph, half, from, along);
                         });
}

template <class N>
Chord<N> Bridges::chord(std::uint32_t half, const BridgeRadius& radius) const {
  const DiagramHalf& own = index_.graph().halves[half];
  const std::uint32_t a = own.feature, b = index_.graph().halves[own.twin].feature;
  const bool is_constant = sites_[a].is_point && sites_[b].is_point;
  const Vector<N> at = is_constant ? Vector<N>{} : place<N>(half, radius);
  return {foot(a, at), foot(b, at)};
}

template Chord<Interval> Bridges::chord(std::uint32_t, const BridgeRadius&) const;
template Chord<RootNumber> Bridges::chord(std::uint32_t, const BridgeRadius&) const;
template Chord<Surd> Bridges::chord(std::uint32_t, const BridgeRadius&) const;
template Vector<Interval> Bridges::place(std::uint32_t, const BridgeRadius&) const;
template Vector<RootNumber> Bridges::place(std::uint32_t, const BridgeRadius&) const;
template Vector<Surd> Bridges::place(std::uint32_t, const BridgeRadius&) const;

}  // namespace minkref::inline disc
