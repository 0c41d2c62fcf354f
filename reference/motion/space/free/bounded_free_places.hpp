// The bounded components of a part's places clear of obstacles, at one scale.
#pragma once

#include <cstdint>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Two routes to the sum of obstacles and turned part that share nothing.
enum class FreeRoute : std::uint8_t { definition, edges };

/// The obstacles, and the set -R at a scale. A place is free if it lies off the closed sum: part
/// and obstacles share no point.
struct FreeProblemAt {
  const Polyhedron& turned;
  const Polyhedron& obstacles;
  const Rational& scale;
  FreeRoute route = FreeRoute::definition;
};

/// Whether the free places have any bounded component: the sum has a cavity. Exact. Throws and
/// costs as `definition_sum` or `edge_sum`.
bool has_bounded_free_places(const FreeProblemAt& problem);

/// Whether a free place lies within a bounded component: inside a shell of the outside with
/// negative volume (`shells`). Exact: counts crossings along a generic ray, by parity. Likewise.
bool is_enclosed(const FreeProblemAt& problem, const SpacePoint& place);

}  // namespace minkref::inline space
