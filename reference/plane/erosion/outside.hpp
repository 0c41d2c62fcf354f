// The outside of a set as an operand.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A closed box less the interior of a polygon set P that lies within it: the closure of P's
/// complement, as far as the box goes. Each ring but the box's own is a ring of P run backwards.
class Outside {
 public:
  PolygonSet set;  ///< valid; ring 0 is the box

  /// `P` has passed `validate` and has an area; the box holds it with room on all sides. Exact.
  /// O(h n) for h holes and n vertices, where boxes do not tell which ring lies in which hole.
  Outside(const PolygonSet& P, const Point& low, const Point& high);

  /// The vertex of P that a vertex of `set` is, and the edge of P that an edge is.
  VertexId vertex_of_P(const VertexId& vertex) const;
  VertexId edge_of_P(const VertexId& edge) const;
  /// The same contact, named by an edge or a vertex of P.
  ConvolutionEdge in_operands(ConvolutionEdge contact) const;

 private:
  struct RingOfP {
    std::uint32_t ring, last;
  };
  std::vector<RingOfP> rings_;
};

/// With a box that is wider than P by three widths on either side, and higher by three heights: the
/// same for all shapes that P is eroded by. Exact. Cost as above.
Outside outside_of(const PolygonSet& P);

/// The box of a set that is not empty: its least and its greatest corner.
struct ExactBox {
  Point low, high;
  explicit ExactBox(const PolygonSet& set);
  void add(const Point& p);
  Rational width() const { return high.x - low.x; }
  Rational height() const { return high.y - low.y; }
};

}  // namespace minkref::inline plane
