// A face's vector area, normal to the face, for any kind of integers.
#pragma once

#include <type_traits>
#include <vector>

#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

template <class Point>
using AreaVector = std::conditional_t<std::is_same_v<Point, WordVector>, WideVector, IntegerVector>;

/// Twice the vector area of a closed ring: for a planar one normal to its plane, on the side from
/// which the ring runs counter-clockwise. Words must be within their limits (word_vectors.hpp).
template <class Point>
AreaVector<Point> area_vector(const std::vector<Point>& points, const Face& face) {
  AreaVector<Point> sum{0, 0, 0};
  for (std::size_t k = 2; k < face.size(); ++k) {
    sum = sum + cross(points[face[k - 1]] - points[face[0]], points[face[k]] - points[face[0]]);
  }
  return sum;
}

}  // namespace minkref::inline space
