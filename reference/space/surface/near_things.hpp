// Pairs of points, segments and polygons in space that may share more than a corner.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// Segments, or polygons by the corners of their outer rings, numbered in the order in which they
/// are added.
class NearThings {
 public:
  /// The points, distinct; they must live longer.
  explicit NearThings(const std::vector<SpaceVertex>& points) : points_(points) {}

  void add(std::vector<std::uint32_t> corners);
  const std::vector<std::uint32_t>& corners(std::uint32_t thing) const { return corners_[thing]; }
  /// Whether a thing with few corners has the point as a corner; false if it has many.
  bool has_corner(std::uint32_t thing, std::uint32_t point) const;

  using Report = std::function<void(std::uint32_t, std::uint32_t)>;
  /// Calls report(i, j), i < j, for each pair of things with overlapping boxes, perhaps twice;
  /// leaves out only pairs that lie apart but for one corner that both have. `first` says from
  /// which thing on pairs are of interest: j >= first > i, or all for 0. Near-linear where few
  /// things are near each other in more than a corner, be they fans of slivers; a thing with many
  /// corners is taken as its box. Can be interrupted.
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
