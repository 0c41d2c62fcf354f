// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a planar facet with holes into triangles.
#pragma once

#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

/// Appends triangles of the facet bounded by the cycles, counter-clockwise seen from the side to
/// which `normal` points. Adds no vertex and leaves none on a triangle's side, so facets still
/// share their edges. Exact.
void triangulate_facet(const std::vector<SpacePoint>& vertices, const std::vector<Face>& cycles,
                       const SpacePoint& normal, std::vector<Face>& triangles);

}  // namespace minkref::cgal_oracle
