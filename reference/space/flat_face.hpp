// A planar face seen along an axis, on its own side.
#pragma once

#include <cstdint>
#include <utility>

#include "reference/space/area_vector.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::inline space {

/// Views the face along its normal's longest axis, which shows the face faithfully.
class FlatFace {
 public:
  /// Keeps a reference to the signs.
  FlatFace(const Face& face, const VertexSigns& signs) : signs_(signs) {
    const IntegerVector normal = area_vector(signs.points(), face);
    axis_ = longest_axis(normal);
    side_ = normal[axis_].sign();
  }

  /// 1 where the three vertices turn as the face does. Exact.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return signs_.turn(a, b, c, axis_) * side_;
  }

  /// Orders points of the plane along a line, ties across the line; seen with this order from left
  /// to right and ties upwards, the face runs counter-clockwise. Exact.
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const IntegerVector &p = signs_.points()[a], &q = signs_.points()[b];
    const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    const int along = p[i].compare(q[i]);
    return along != 0 ? along * side_ < 0 : p[j] < q[j];
  }

  /// Twice a triangle's area as seen, positive if the triangle turns as the face does.
  Integer seen_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::vector<IntegerVector>& p = signs_.points();
    const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    return side_ *
           ((p[b][i] - p[a][i]) * (p[c][j] - p[a][j]) - (p[b][j] - p[a][j]) * (p[c][i] - p[a][i]));
  }

 private:
  const VertexSigns& signs_;
  std::size_t axis_ = 0;
  int side_ = 0;
};

}  // namespace minkref::inline space
