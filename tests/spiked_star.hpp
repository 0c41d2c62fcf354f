// Stars: long edges in all directions, whose boxes overlap far more often than the edges are near.
#pragma once

#include <cmath>

#include "reference/plane/polygon_set.hpp"

namespace minkref::testing {

/// One ring about the origin, whose vertices are 5 to 10 million away.
inline PolygonSet spiked_star(int vertices) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / vertices, reach = 5e6 + 5e6 * (k * 37 % 64) / 64;
    ring.push_back({std::lround(reach * std::cos(angle)), std::lround(reach * std::sin(angle))});
  }
  return {{{ring, {}}}};
}

}  // namespace minkref::testing
