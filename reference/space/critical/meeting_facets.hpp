// Facets that meet in a window of scales, and where three or four of them do.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/space/critical/critical_events.hpp"

namespace minkref::inline space {

/// Two facets, ascending, and the scales between which they meet, rounded outwards. Their planes
/// are one at all scales, or cross, and then they share no side.
struct MeetingPair {
  std::uint32_t first;
  std::uint32_t second : 31, are_coplanar : 1;
  double low, high;
};

/// Doubles that are not above, not below a number.
double below(const EventScale& number);
double above(const EventScale& number);

/// Whether two facets have a side in common at all scales. If their planes cross such pairs are in
/// no event of three or four facets that is not one of fewer: where the side passes through another
/// facet, its ends and those of the track are events of pairs, and so is all that passes its ends
/// in its plane (docs/definitions.md, Critical scales).
bool share_a_side(const MovingFacet& a, const MovingFacet& b);

/// All events of three and of four facets, from the pairs that meet in the window. Exact.
void add_concurrent_events(const MovingConvolution& convolution, std::vector<MeetingPair> meeting,
                           const EventScale& from, const EventScale& to,
                           const BuildControl& control, MostEvents most, CriticalEvents& result);

/// Throws LimitExceeded for a list that has become too long.
[[noreturn]] void refuse_long_list(MostEvents most);

}  // namespace minkref::inline space
