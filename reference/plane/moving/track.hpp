// A moving point's position as a function of the scale.
#pragma once

#include "reference/plane/moving/edge_nodes.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A point a + s b.
struct Track {
  Point a, b;
  Point at(const Rational& scale) const {
    return {Rational(a.x + scale * b.x), Rational(a.y + scale * b.y)};
  }
};

/// The track of a position along an edge. Exact.
Track track_along(const RationalEdge& edge, const PositionAlong<Rational>& position);

}  // namespace minkref::inline plane
