// An event of P's outer Voronoi diagram, and the places that features single out.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/diagram/equidistant.hpp"

namespace minkref::inline disc {

/// Numbers of features, ascending.
using Features = std::vector<std::uint32_t>;

/// A place outside of P, as far from three features or more, or right between two.
struct DiagramEvent {
  enum class Kind : std::uint8_t {
    corner,   ///< of the diagram: curves start or stop to be on the boundary
    joint,    ///< where a line goes on as an arc passes another curve
    saddle,   ///< between two features: arcs, or an arc and a line, start to touch
    ridge,    ///< between two opposite features, with a third as near: perhaps everything between
              ///< parallel edges is reached at once
    maximum,  ///< of the distance from P: a hole ends
  };
  Kind kind;
  Features features;  ///< all that are as near
  /// Lines among them, each with the end that the place lies right in front of.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joints;
  Vector<Interval> at;  ///< in the frame of the curves, and so is the squared radius
  Interval squared_radius;
  Features of;      ///< two or three of the features, which tell the place
  unsigned branch;  ///< which of the places that they tell
  /// By feature: for a line the number of the edge in front of which the place lies (if two edges
  /// of the line meet right there, the edge that ends); none for a vertex.
  std::vector<std::uint32_t> edges = {};

  /// How many points of P lie equally near.
  std::size_t nearest_points() const { return features.size() - joints.size(); }
};

/// Doubles around a number, by MPFR: intervals of doubles may leave nothing of a difference. Close
/// to the number, unless the number is 0 or nearer to 0 than any number with some thousand digits
/// need be.
inline Interval tight(const RootNumber& number) {
  constexpr long first_bits = 256, most_bits = 8192;
  for (long bits = first_bits;; bits *= 2) {
    const auto [low, high] = number.enclosure(bits).outwards();
    if (bits >= most_bits || !(high - low > 0x1p-51 * std::max(std::abs(low), std::abs(high)))) {
      return {low, high};
    }
  }
}
inline Equidistant<Interval> tight(const Equidistant<RootNumber>& place) {
  return {{tight(place.at.x), tight(place.at.y)}, tight(place.squared_radius)};
}

/// The places that two or three features single out: none, one or two. Throws UndecidedSign if
/// intervals leave the number open.
template <class N>
std::vector<Equidistant<N>> equidistant_places(const OffsetCurves& curves,
                                               const Features& features) {
  const auto site = [&](std::uint32_t feature) { return Site::of(curves, feature); };
  if (features.size() == 2) {
    return EquidistantPoints<N>::between(site(features[0]), site(features[1]));
  }
  for (const std::uint32_t line : features) {
    const Site own = site(line);
    if (own.is_point) continue;
    for (const std::uint32_t end : features) {
      const Site point = site(end);
      if (!point.is_point || dot(own.normal, from_to(own.point, point.point)) != 0) continue;
      const auto other = std::find_if(features.begin(), features.end(),
                                      [&](std::uint32_t f) { return f != line && f != end; });
      return EquidistantPoints<N>::in_front(point.point, own, site(*other));
    }
  }
  return EquidistantPoints<N>::of(site(features[0]), site(features[1]), site(features[2]));
}

}  // namespace minkref::inline disc
