// Events of three facets, two or all of which share one plane at all scales.
#pragma once

#include <array>
#include <vector>

#include "reference/space/critical/concurrent_facets.hpp"

namespace minkref::inline space {

/// Three facets with ascending numbers, two of them coplanar at all scales. The third facet crosses
/// this plane or lies there too.
struct CoplanarTriple {
  static constexpr std::size_t none = 3;
  std::array<FacetTracks::Facet, 3> facets;
  std::size_t across;  ///< which of them crosses the plane, or none
};

/// Adds the events where a side of each facet in the plane passes through one point, which lies on
/// the facet across, if any; skips points where two of the three have an event at the same scale.
/// Exact, with a constant number of steps: signs by doubles with bounds, else by integers.
void add_coplanar_events(const MovingConvolution& convolution, const CoplanarTriple& triple,
                         const FacetTracks::Window& window, SignCounts& signs,
                         std::vector<ConcurrentEvent>& events);

/// The event's place, in the convolution's units. Exact.
std::array<Rational, 3> place_in_plane(const MovingConvolution& convolution,
                                       const ConcurrentEvent& event);

}  // namespace minkref::inline space
