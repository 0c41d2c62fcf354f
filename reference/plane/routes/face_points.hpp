// An interior point for every face of the arrangement of the reduced convolution.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

struct FacePoint {
  Point point;  ///< in real coordinates, exact
  bool in_sum;  ///< by the paper's route
};

/// For checking the paper's route face by face against another judge: every bounded face of the
/// arrangement at this scale, in no particular order. Throws as minkowski_sum does. Exact. The cost
/// of the route plus O(size) a face.
std::vector<FacePoint> face_points(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

}  // namespace minkref::inline plane
