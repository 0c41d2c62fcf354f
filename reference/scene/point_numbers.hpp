// Numbers for points: equal points have the same.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/point_predicates.hpp"

namespace minkref::inline scene {

/// Numbers for points, which must outlive it; equal points have the same number.
class PointNumbers {
 public:
  std::uint32_t number(const FilteredPoint& point);
  /// no_entry for a point that has none.
  std::uint32_t find(const FilteredPoint& point) const;
  const std::vector<const FilteredPoint*>& points() const { return points_; }
  const FilteredPoint& operator[](std::uint32_t number) const { return *points_[number]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

 private:
  std::uint32_t find(const FilteredPoint& point, std::uint64_t digest) const;
  void grow();

  std::vector<const FilteredPoint*> points_;
  std::vector<std::uint64_t> digests_;
  std::vector<std::uint32_t> next_;   ///< point in the same bucket
  std::vector<std::uint32_t> first_;  ///< of each bucket, a power of two
};

}  // namespace minkref::inline scene
