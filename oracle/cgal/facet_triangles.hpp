// SPDX-License-Identifier: GPL-3.0-or-later
// A planar facet with holes cut into triangles.
#pragma once

#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

/// Appends the triangles of the facet that the cycles of vertices bound, counter-clockwise seen
/// from where `normal` points. No vertex is added, and none lies on the side of a triangle: facets
/// that share edges still do. Exact.
void triangulate_facet(const std::vector<SpacePoint>& vertices, const std::vector<Face>& cycles,
                       const SpacePoint& normal, std::vector<Face>& triangles);

}  // namespace minkref::cgal_oracle
