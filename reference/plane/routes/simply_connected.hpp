// Polygon sets cut along slits into weakly simple rings, and their triangulation.
#pragma once

#include <array>
#include <vector>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/convolution/convolution_type.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The set with its holes joined to their outer rings by slits between vertices: one weakly simple
/// ring for each connected component of the interior, as `outer`, and no holes. Every vertex of the
/// result belongs to the set. The interior less the slits is simply connected. Returns sets without
/// holes, points and segments unchanged. Exact. O(n log n) if slits are short (joined_holes.hpp).
PolygonSet cut_to_simply_connected(const PolygonSet& set);

/// The operand whose convolution is followed to find a sum: cut for the full convolution.
inline PolygonSet followed_operand(const PolygonSet& set, ConvolutionType of) {
  return of == ConvolutionType::full ? cut_to_simply_connected(set) : set;
}

using Triangle = std::array<Point, 3>;

/// A triangulation of the set by diagonals between vertices, counter-clockwise triangles. Throws
/// std::logic_error if the areas do not add up (never seen). Exact. O(n^2).
std::vector<Triangle> triangulate(const PolygonSet& set);

/// A triangulation of a single connected region, given by the walks along its border
/// (boundary_walks) as point numbers: every vertex of the walks is a corner of some triangle, also
/// on a straight border. Walks may run along slits; a hole may be a single point. Areas are not
/// checked. Exact. O(n^2).
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<FilteredPoint>& points, const std::vector<std::uint32_t>& outer,
    const std::vector<std::vector<std::uint32_t>>& holes);

}  // namespace minkref::inline plane
