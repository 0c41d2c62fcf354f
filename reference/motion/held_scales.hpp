// Scales where an assembly holds a part: the part fits at its place, and a given way out is blocked
// (Behar & Lien 2012, Section 8.1, "part removal").
#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// The contact at an end of a held range.
template <class Bound>
struct HeldEndOf {
  bool at_place = false;  ///< the contact is one at the part's place; otherwise one of the way
  Bound contact;
};

/// A held scale range.
template <class Bound>
struct HeldRangeOf {
  ScaleRange scales;
  std::optional<HeldEndOf<Bound>> begin, end;  ///< none at an end of the window
  /// At `scales.sample()`: the first place of the way where the part collides, or the limit of such
  /// places, with the contact there. The part gets so far, and no further.
  Bound stop;
};

template <class Bound>
struct HeldScalesOf {
  ValidScalesOf<Bound> fits;             ///< at the way's first vertex
  ValidScalesOf<Bound> way;              ///< all along the way; all of them fit
  std::vector<HeldRangeOf<Bound>> held;  ///< the scales that fit without those of the way
};
using HeldScales = HeldScalesOf<PathBound>;

/// The scales of the window at which the part lies among the obstacles at the way's first vertex
/// without a collision, and collides somewhere on the way. A single way gives no more than a lower
/// bound on the scales at which the part is trapped (`trapped_scales`): a held part may have
/// another way out, but a part that is trapped is held on every way that ends far away. Exact.
/// Throws and costs as `valid_scales`.
HeldScales held_scales(const PolygonSet& part, const PolygonSet& obstacles,
                       const std::vector<Point>& way, ContactRule rule = ContactRule::allowed,
                       const ScaleWindow& window = {}, PathRoute route = PathRoute::pieces);

/// A window's scales from `all` without `some`, both sorted and disjoint. Exact.
std::vector<ScaleRange> scales_without(const std::vector<ScaleRange>& all,
                                       const std::vector<ScaleRange>& some,
                                       const ScaleWindow& window);

/// Puts the answer together from the scales at the place and of the way. `stops_at` finds the stops
/// at some held scales. Exact.
template <class Bound, class Stops>
HeldScalesOf<Bound> held_of(ValidScalesOf<Bound> fits, ValidScalesOf<Bound> way,
                            const ScaleWindow& window, const Stops& stops_at) {
  HeldScalesOf<Bound> result{std::move(fits), std::move(way), {}};
  const auto contact = [&](bool at_place, const Rational& scale, bool blocks) {
    const std::vector<Bound>& bounds = at_place ? result.fits.bounds : result.way.bounds;
    for (const Bound& bound : bounds) {
      if (bound.scale == scale && bound.blocks == blocks) return HeldEndOf<Bound>{at_place, bound};
    }
    throw std::logic_error("an end of held scales without a contact");
  };
  const auto begins = [](const std::vector<ScaleRange>& ranges, const ScaleCut& cut) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [&](const ScaleRange& range) { return range.from == cut; });
  };
  const ScaleRange all = range_of(window);
  std::vector<Rational> samples;
  for (const ScaleRange& range : scales_without(result.fits.valid, result.way.valid, window)) {
    HeldRangeOf<Bound> held{range, {}, {}, {}};
    if (range.from != all.from) {
      const bool at_place = begins(result.fits.valid, range.from);
      held.begin = contact(at_place, range.from.scale, !at_place);
    }
    if (range.to && range.to != all.to) {
      const bool at_place = !begins(result.way.valid, *range.to);
      held.end = contact(at_place, range.to->scale, at_place);
    }
    samples.push_back(range.sample());
    result.held.push_back(std::move(held));
  }
  if (samples.empty()) return result;
  std::vector<Bound> stops = stops_at(samples);
  for (std::size_t k = 0; k < stops.size(); ++k) result.held[k].stop = std::move(stops[k]);
  return result;
}

}  // namespace minkref::inline motion
