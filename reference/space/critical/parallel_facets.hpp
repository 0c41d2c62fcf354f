// Parallel facets that come to lie in one plane, or always do (Sec. 5, Fig. 4).
#pragma once

#include <vector>

#include "reference/space/critical/facet_event.hpp"

namespace minkref::inline space {

/// Events of two facets with parallel normals at scales above 0, in a window if one is given,
/// ascending. Facets that lie in one plane at one scale meet at that scale only: kind `parallel`
/// where they have an area in common, else `vertex`. Facets that always lie in one plane have
/// events where a corner of one comes to lie on a side of the other, in both. Exact.
std::vector<FacetEvent> parallel_events(const MovingConvolution& convolution,
                                        const MovingFacet& first, const MovingFacet& second,
                                        SignCounts& signs, const ScaleWindow* window = nullptr);

/// Whether two facets with parallel normals lie in one plane at all scales. Exact.
bool are_coplanar(const MovingConvolution& convolution, const MovingFacet& first,
                  const MovingFacet& second);

/// Whether two facets with parallel normals have a point in common at a scale. Exact.
bool parallel_facets_meet(const MovingConvolution& convolution, const MovingFacet& first,
                          const MovingFacet& second, const Rational& s);

}  // namespace minkref::inline space
