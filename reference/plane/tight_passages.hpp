// Tight passages: the points and polylines inside a sum that the sum of the interiors misses.
#pragma once

#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// A maximal piece: a point, or a polyline between points at which one piece ends or at least three
/// meet (docs/definitions.md, "Tight passages").
struct TightPassage {
  /// A single point; or a polyline's vertices, collinear vertices merged, the first vertex again at
  /// the end of a closed polyline.
  std::vector<Point> points;
  /// The contacts of the shapes. contacts[i]: the edges of the reduced convolution, sorted, that
  /// cover the segment from points[i] to points[i + 1] or a part of it; contacts[0] of a point: the
  /// edges through the point.
  std::vector<std::vector<ConvolutionEdge>> contacts;
  friend bool operator==(const TightPassage&, const TightPassage&) = default;
};

/// The closure of int(sP + Q) less (ri sP + ri Q) at a rational scale s > 0, in canonical order:
/// each polyline runs with the smaller of its two vertex sequences, which also sorts the pieces.
/// Exact. The operands must have passed `validate`. Throws BadInput as minkowski_sum does. Cost:
/// the arrangement of the reduced convolution, O((N + k) log N), and the decision of a point
/// (witness.hpp) for each sub-edge covered both ways and for each node surrounded by segments
/// through it; generic operands have none.
std::vector<TightPassage> tight_passages(const PolygonSet& P, const PolygonSet& Q,
                                         const Rational& scale);

}  // namespace minkref::inline plane
