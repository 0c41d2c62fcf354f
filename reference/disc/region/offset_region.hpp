// P ⊕ ρD as a region: components of its interior, with their holes, and its canonical form.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/disc/curves/offset_form.hpp"
#include "reference/disc/distance/static_offset.hpp"
#include "reference/number/interval.hpp"

namespace minkref::inline disc {

/// A simple ring, the region on its left: pieces, by number, one after the other. Where the
/// boundary touches itself rings are split.
struct OffsetRing {
  std::vector<std::uint32_t> pieces;
  /// The curves, by features: consecutive pieces of one curve are one. In canonical order, which
  /// starts somewhere else than the pieces.
  std::vector<std::uint32_t> curves;
};

struct OffsetComponent {
  OffsetRing outer;
  std::vector<OffsetRing> holes;
};

struct OffsetRegion {
  /// In a frame of its own: numbers of `offset` are measured from `origin`.
  StaticOffset offset;
  Point origin{0, 0};
  std::vector<OffsetComponent> components;  ///< in canonical order
  std::size_t holes = 0;  ///< bounded components of the complement, perhaps between components
};

/// How the boundary is found: by distances from P (static_offset), or by winding numbers of the
/// convolution (arc_convolution; Behar & Lien 2012, Sec. 3 and Appendix).
enum class OffsetRoute : std::uint8_t { definition, paper };

/// The route of that name. Throws BadInput ("unknown-route").
OffsetRoute offset_route_named(std::string_view name);

/// The region for a valid polygon set, perhaps a point or a segment, or the empty one. Throws
/// BadInput ("bad-radius") unless squared_radius > 0. Exact, and equal by both routes; the cost is
/// that of the route, and O(n log n). The route `paper` uses one thread.
OffsetRegion offset_region(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options = {},
                           OffsetRoute route = OffsetRoute::definition);

/// The canonical text (docs/disc.md): rings of curves. Rational, since a corner is where a
/// curve enters what is near the next, which is one place.
std::string canonical_json(const OffsetRegion& region);

struct OffsetMeasures {
  Interval area, length;
};
/// The two doubles next to each number, from exact corners by as many bits as it takes.
OffsetMeasures measures(const OffsetRegion& region);

/// Whether enclosures are wider by less than `widest_measure` of the number.
bool is_sharp(const OffsetMeasures& found);
constexpr double widest_measure = 0x1p-36;

}  // namespace minkref::inline disc
