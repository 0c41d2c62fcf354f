#include "reference/motion/space/free/free_turn.hpp"

#include <stdexcept>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/definition/tight_passages.hpp"

namespace minkref::inline space {

bool FreeTurn::is_small(const Rational& scale, FreeRoute route) const {
  look_for_interrupt();
  return small_({turned_, obstacles_, scale, route});
}

std::pair<Rational, Rational> FreeTurn::bracket(Rational high) const {
  constexpr int steps = 10;
  Rational low = high / 2;
  while (!is_small(low)) {
    high = low;
    low /= 2;
  }
  for (int k = 0; k < steps; ++k) {
    Rational middle = (low + high) / 2;
    (is_small(middle) ? low : high) = std::move(middle);
  }
  return {low, high};
}

std::vector<SpacePoint> FreeTurn::passages_at(const Rational& scale) const {
  TightPassagesInSpace found;
  try {
    found = tight_passages_in_space(turned_, obstacles_, {scale, scale, scale});
  } catch (const LimitExceeded&) {
    return {};  // too many pieces: the places of events are left
  }
  std::vector<SpacePoint> places = found.points;
  for (const auto& line : found.lines) places.push_back(line.first);
  for (const PlaneRegion& sheet : found.sheets) {
    for (const Polygon& polygon : sheet.region.polygons) {
      places.push_back(lifted(polygon.outer[0], sheet.plane));
    }
  }
  return places;
}

std::optional<FoundTurn> FreeTurn::find(const FreeEvents& events, const Rational& low,
                                        const Rational& high, bool is_high_large,
                                        const IsFree& is_free) const {
  const std::vector<Rational>& scales = events.scales();
  const auto above = [&](std::size_t k) {
    return Rational((scales[k] + (k + 1 < scales.size() ? scales[k + 1] : high)) / 2);
  };
  std::size_t first = 0, last = scales.size();
  while (first < last) {
    const std::size_t middle = (first + last) / 2;
    if (scales[middle] == high ? is_high_large : !is_small(above(middle))) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  if (first == scales.size()) return std::nullopt;
  FoundTurn found{scales[first], {}, {}};
  const Rational below = ((first > 0 ? scales[first - 1] : low) + found.scale) / 2;
  const Rational over = found.scale == high ? high * (1 + Rational(1, 1 << 20)) : above(first);
  for (const auto& [scale, small] : {std::pair(below, true), std::pair(over, false)}) {
    if (is_small(scale, FreeRoute::edges) != small) {
      throw std::logic_error("the sum from edges at " + to_string(scale) + " differs");
    }
    found.proofs.emplace_back(scale, small);
  }
  // Where free places split or vanish, sums close on both sides of a passage. Elsewhere sums may
  // touch only at an event's point.
  for (const bool of_passages : {true, false}) {
    const auto places = of_passages ? passages_at(found.scale) : events.places_at(found.scale);
    for (const SpacePoint& place : places) {
      look_for_interrupt();
      if (!is_free(found.scale, place)) continue;
      found.at = place;
      return found;
    }
  }
  throw std::logic_error("no free place at the event where free places change");
}

}  // namespace minkref::inline space
