// Events of three facets of which two, or all, lie in one plane at all scales.
#pragma once

#include <array>
#include <vector>

#include "reference/space/critical/concurrent_facets.hpp"

namespace minkref::inline space {

/// Three facets, ascending by number, two of which lie in one plane at all scales. The
/// third crosses that plane, or lies in it too.
struct CoplanarTriple {
  static constexpr std::size_t none = 3;
  std::array<FacetTracks::Facet, 3> facets;
  std::size_t across;  ///< which of them crosses the plane, or none
};

/// Where a side of each facet in the plane passes through one point, which is on the facet across
/// if there is one; none where two of the three have an event at that scale and point. Exact, of a
/// constant number of steps: signs by doubles with bounds, else by integers.
void add_coplanar_events(const MovingConvolution& convolution, const CoplanarTriple& triple,
                         const FacetTracks::Window& window, SignCounts& signs,
                         std::vector<ConcurrentEvent>& events);

/// Where it happens, in the units of the convolution. Exact.
std::array<Rational, 3> place_in_plane(const MovingConvolution& convolution,
                                       const ConcurrentEvent& event);

}  // namespace minkref::inline space
