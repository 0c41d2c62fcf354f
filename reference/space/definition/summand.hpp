// The sum of two convex operands, by supporting planes.
#pragma once

#include <vector>

#include "reference/plane/kernel/box.hpp"
#include "reference/space/definition/corner.hpp"

namespace minkref::inline space {

/// A point, a segment or a convex polyhedron.
struct Summand {
  explicit Summand(const Polyhedron& piece);

  IntegerPoints vertices;
  std::vector<std::array<double, 3>> rounded;  ///< nearest doubles of the vertices
  std::vector<IntegerVector> normals;          ///< of its facets, primitive
  std::vector<IntegerVector> directions;       ///< of its edges, primitive, one for each line
};

/// A facet of a sum: the plane, and the corners, counter-clockwise along the viewing axis.
struct SumFacet {
  CuttingPlane plane;
  CornerRing ring;
};

/// A convex polyhedron: the points below all planes.
struct SumBody {
  std::vector<SumFacet> facets;  ///< none where the sum has no volume
  Box flat_box;                  ///< encloses it, in x and y
  double bottom = 0, top = 0;    ///< and in z
};

/// Returns A ⊕ B. By a facet's definition, n is a facet's normal iff the vertices of A and B
/// farthest along n span a plane between them; such an n is normal to a facet of A or B, or at
/// right angles to an edge of each. Exact. O((a b + f) v) for a and b edge directions, f facets and
/// v vertices of both; doubles discard most of these products.
SumBody sum_of(const Summand& A, const Summand& B);

}  // namespace minkref::inline space
