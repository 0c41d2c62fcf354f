// Pairs of segments and polygons in space with more in common than a corner, perhaps.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// Segments, and polygons by their outer corners, numbered as added.
class NearThings {
 public:
  /// The points, distinct; they must live longer.
  explicit NearThings(const std::vector<SpaceVertex>& points) : points_(points) {}

  void add(std::vector<std::uint32_t> corners);
  const std::vector<std::uint32_t>& corners(std::uint32_t thing) const { return corners_[thing]; }
  /// Whether the point is a corner; false for things with many corners.
  bool has_corner(std::uint32_t thing, std::uint32_t point) const;

  using Report = std::function<void(std::uint32_t, std::uint32_t)>;
  /// Calls report(i, j), i < j, for each pair of things with overlapping boxes, perhaps twice;
  /// leaves out only pairs without a common point, or with a single common corner. Reports pairs
  /// with j >= first > i, or all for 0. Near-linear for fans; a box stands for a thing with many
  /// corners. Can be interrupted.
  void pairs(const Report& report, std::uint32_t first = 0) const;

 private:
  static constexpr std::size_t few_corners = 8;
  bool has_few(std::uint32_t thing) const { return corners_[thing].size() <= few_corners; }
  bool pairs_by_boxes(const Report& report, std::uint32_t first) const;
  void pairs_by_clusters(const Report& report) const;

  const std::vector<SpaceVertex>& points_;
  std::vector<std::vector<std::uint32_t>> corners_;
  std::vector<SpaceBox> boxes_;
};

}  // namespace minkref::inline space
