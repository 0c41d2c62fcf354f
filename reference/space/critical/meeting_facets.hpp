// Facets that meet within a window of scales, and where three or four meet.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/space/critical/critical_events.hpp"

namespace minkref::inline space {

/// Two facets, ascending, and the scales between which the facets meet, rounded outwards. Their
/// planes coincide at all scales, or cross; facets with crossing planes share no side.
struct MeetingPair {
  std::uint32_t first;
  std::uint32_t second : 31, are_coplanar : 1;
  double low, high;
};

/// Doubles not above, or not below, a number.
double below(const EventScale& number);
double above(const EventScale& number);

/// Whether two facets share a side at all scales. If the planes cross, such pairs add no event of
/// three or four facets beyond the events of fewer: where the side passes through another facet,
/// the ends of the side and of the track are pair events, and so is everything that passes the
/// side's ends within the facet's plane (docs/definitions.md, Critical scales).
bool share_a_side(const MovingFacet& a, const MovingFacet& b);

/// Adds all events of three and four facets, from the pairs that meet within the window. Exact.
void add_concurrent_events(const MovingConvolution& convolution, std::vector<MeetingPair> meeting,
                           const EventScale& from, const EventScale& to,
                           const BuildControl& control, MostEvents most, CriticalEvents& result);

/// Throws LimitExceeded for a list that has become too long.
[[noreturn]] void refuse_long_list(MostEvents most);

}  // namespace minkref::inline space
