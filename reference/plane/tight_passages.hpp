// Tight passages: the points and polylines inside a sum that the sum of the interiors misses.
#pragma once

#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// A maximal piece: a point, or a polyline that ends where one or more than two of them meet
/// (docs/definitions.md, "Tight passages").
struct TightPassage {
  /// One point; or the vertices of a polyline, collinear ones merged, the first one again at the
  /// end where it is closed.
  std::vector<Point> points;
  /// Where the shapes touch. contacts[i]: the edges of the reduced convolution, sorted, that cover
  /// the segment from points[i] to points[i + 1] or a part of it; contacts[0] of a point: those
  /// through it.
  std::vector<std::vector<ConvolutionEdge>> contacts;
  friend bool operator==(const TightPassage&, const TightPassage&) = default;
};

/// The closure of int(sP + Q) less (ri sP + ri Q) at a rational scale s > 0, in canonical order:
/// each polyline runs so that its vertices are the smaller sequence of the two, and the pieces are
/// sorted by theirs. Exact. The operands must have passed `validate`. Throws BadInput as
/// minkowski_sum does. Cost: the arrangement of the reduced convolution, O((N + k) log N), and the
/// decision of one point (witness.hpp) for each sub-edge that is covered in both directions and for
/// each node that segments through it surround; generic operands have none.
std::vector<TightPassage> tight_passages(const PolygonSet& P, const PolygonSet& Q,
                                         const Rational& scale);

}  // namespace minkref::inline plane
