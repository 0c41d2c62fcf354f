// How two triangles of a closed surface meet: whether the surface crosses or covers itself there.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/surface_triangles.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::inline space {

enum class TriangleContact {
  none,      ///< disjoint, or touching at points and along lines
  crossing,  ///< the surface passes through itself along a segment
  overlap,   ///< they share an area
};

/// The contact between two triangles from different faces. The surface crosses itself along a line
/// of contact if the half-planes at which one sheet meets the line lie on different sides of the
/// other sheet: a sheet is the inside of a triangle, or two triangles at their common edge. If
/// half-planes of both sheets coincide, their triangles overlap, and the given pair may be called
/// none. Exact. O(1).
TriangleContact contact_of(const std::vector<SurfaceTriangle>& triangles, const VertexSigns& signs,
                           std::uint32_t first, std::uint32_t second);

/// A point inside two triangles' common part: the middle of a segment, say. The triangles have to
/// meet. Exact; measured with the unit of the points of `signs`.
std::array<Rational, 3> common_point(const SurfaceTriangle& first, const SurfaceTriangle& second,
                                     const VertexSigns& signs);

}  // namespace minkref::inline space
