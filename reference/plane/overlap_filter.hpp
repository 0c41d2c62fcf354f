// A certain test with doubles that two triangles' interiors meet.
#pragma once

#include <array>
#include <vector>

#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {

/// The vertices of a triangle as the nearest doubles, with a bound on their absolute values.
struct NearTriangle {
  std::array<double, 3> x{}, y{};
  double magnitude = 0;

  NearTriangle() = default;
  explicit NearTriangle(const std::vector<FilteredPoint>& triangle);
};

/// Whether the interiors of `a` and `at` - `b` meet: true is certain, false says nothing. Both
/// triangles run counter-clockwise. Source: the separating axis theorem; the source proves the
/// bound on a turn's rounding.
bool certainly_overlap(const NearTriangle& a, const NearTriangle& b, const FilteredPoint& at);

}  // namespace minkref::inline plane
