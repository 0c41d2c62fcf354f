#include "reference/plane/overlap_filter.hpp"

#include <algorithm>
#include <cmath>

namespace minkref::inline plane {
namespace {

/// Let u = 2^-53 and R bound the absolute values of all vertices; the sum of the bounds bounds
/// reflected vertices. Vertices have errors of at most u R, reflected vertices 3 u R; differences
/// of two are at most 2 R (up to such terms) with errors of 8 u R; a product of two differences has
/// an error of 2 * 2 R * 8 u R + 4 u R^2 and terms in u^2, together less than 37 u R^2; the
/// difference of two products less than 2 * 37 u R^2 + 8 u R^2 = 82 u R^2. The bound takes 128 u
/// R^2. If this is too small for relatively rounded products, nothing is certain.
double turn_bound(double magnitude) {
  return std::max(128 / 9007199254740992.0 * magnitude * magnitude, 1e-280);
}

/// Whether every edge line of `a` has a vertex of `b` on its inner side, beyond the bound.
bool none_separates(const NearTriangle& a, const NearTriangle& b, double bound) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double dx = a.x[next] - a.x[i], dy = a.y[next] - a.y[i];
    bool inner = false;
    for (std::size_t j = 0; !inner && j < 3; ++j) {
      inner = dx * (b.y[j] - a.y[i]) - dy * (b.x[j] - a.x[i]) > bound;
    }
    if (!inner) return false;
  }
  return true;
}

}  // namespace

NearTriangle::NearTriangle(const std::vector<FilteredPoint>& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = triangle[i].x();
    y[i] = triangle[i].y();
    magnitude = std::max({magnitude, std::abs(x[i]), std::abs(y[i])});
  }
}

bool certainly_overlap(const NearTriangle& a, const NearTriangle& b, const FilteredPoint& at) {
  const double magnitude =
      std::max(a.magnitude, b.magnitude + std::max(std::abs(at.x()), std::abs(at.y())));
  if (!(magnitude < 1e150)) return false;  // products would overflow
  NearTriangle reflected = b;
  for (double& x : reflected.x) x = at.x() - x;
  for (double& y : reflected.y) y = at.y() - y;
  const double bound = turn_bound(magnitude);
  return none_separates(a, reflected, bound) && none_separates(reflected, a, bound);
}

}  // namespace minkref::inline plane
