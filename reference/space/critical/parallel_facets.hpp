// Parallel facets that reach one plane, or always share one (Sec. 5, Fig. 4).
#pragma once

#include <vector>

#include "reference/space/critical/facet_event.hpp"

namespace minkref::inline space {

/// Finds the events of two facets with parallel normals at scales above 0, ascending, within a
/// window if given. Facets coplanar at one scale meet at this scale only: kind `parallel` if they
/// share an area, else `vertex`. Facets coplanar at all scales have events where one facet's corner
/// reaches the other's side. Exact.
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
