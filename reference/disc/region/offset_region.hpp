// P ⊕ ρD as a region: components of the interior, with holes, and the canonical form.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/disc/curves/offset_form.hpp"
#include "reference/disc/distance/static_offset.hpp"
#include "reference/number/interval.hpp"

namespace minkref::inline disc {

/// A simple ring, with the region on the left: piece numbers, one after the other. Rings split
/// where the boundary touches itself.
struct OffsetRing {
  std::vector<std::uint32_t> pieces;
  /// The curves, by feature: consecutive pieces of one curve count once. Canonical order, which
  /// starts elsewhere than the pieces.
  std::vector<std::uint32_t> curves;
};

struct OffsetComponent {
  OffsetRing outer;
  std::vector<OffsetRing> holes;
};

struct OffsetRegion {
  /// Measures numbers of `offset` from `origin`.
  StaticOffset offset;
  Point origin{0, 0};
  std::vector<OffsetComponent> components;  ///< in canonical order
  std::size_t holes = 0;  ///< bounded components of the complement, perhaps between components
};

/// The route to the boundary: by distances from P (static_offset), or by winding numbers of the
/// convolution (arc_convolution; Behar & Lien 2012, Sec. 3 and Appendix).
enum class OffsetRoute : std::uint8_t { definition, paper };

/// The route with this name. Throws BadInput ("unknown-route").
OffsetRoute offset_route_named(std::string_view name);

/// The region for a valid polygon set, perhaps a point or a segment, or the empty one. Throws
/// BadInput ("bad-radius") unless squared_radius > 0. Exact, and equal by both routes; costs as
/// much as the route, plus O(n log n). The route `paper` uses one thread.
OffsetRegion offset_region(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options = {},
                           OffsetRoute route = OffsetRoute::definition);

/// The canonical text (docs/disc.md): rings of curves. Rational, since a corner is the single place
/// where a curve enters the next curve's neighbourhood.
std::string canonical_json(const OffsetRegion& region);

struct OffsetMeasures {
  Interval area, length;
};
/// The two doubles next to each number, from exact corners by as many bits as it takes.
OffsetMeasures measures(const OffsetRegion& region);

/// Whether each enclosure is narrower than `widest_measure` times the number.
bool is_sharp(const OffsetMeasures& found);
constexpr double widest_measure = 0x1p-36;

}  // namespace minkref::inline disc
