// Whether obstacles together cover a neighbourhood of a point.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline scene {

/// A directed edge with its polygon set's interior on the left.
struct ObstacleEdge {
  Point from, to;
};

/// Whether a point lies on a closed edge, which may be a point.
bool lies_on(const ObstacleEdge& edge, const Point& p);

/// Whether the union of sets, each given by its edges, has a point in its interior. The sets hold
/// the point, none of them in its own interior. Exact; O(n) for each edge at the point.
bool cover_together(const std::vector<std::vector<ObstacleEdge>>& sets, const Point& p);

}  // namespace minkref::inline scene
