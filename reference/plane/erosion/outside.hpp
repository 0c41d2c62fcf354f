// The outside of a set as an operand.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A closed box less the interior of a polygon set P inside: P's closed complement within the box.
/// Each ring except the box's own is a ring of P, run backwards.
class Outside {
 public:
  PolygonSet set;  ///< valid; ring 0 is the box

  /// `P` has passed `validate` and has an area; the box holds it with room on all sides. Exact.
  /// O(h n) for h holes and n vertices, unless boxes tell nested rings apart.
  Outside(const PolygonSet& P, const Point& low, const Point& high);

  /// Name P's vertex or edge behind a vertex or edge of `set`.
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

/// Makes the outside within a box three widths of P wider on either side, and three heights higher:
/// one operand for all eroding shapes. Exact. Cost as above.
Outside outside_of(const PolygonSet& P);

/// A nonempty set's box: least and greatest corner.
struct ExactBox {
  Point low, high;
  explicit ExactBox(const PolygonSet& set);
  void add(const Point& p);
  Rational width() const { return high.x - low.x; }
  Rational height() const { return high.y - low.y; }
};

}  // namespace minkref::inline plane
