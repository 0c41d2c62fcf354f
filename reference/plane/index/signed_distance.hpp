// Signed distances to the boundary of a region, as certain lower bounds in doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A closed disc inside a region.
struct Disc {
  double x = 0, y = 0, radius = 0;
};

/// For points inside the distance to the boundary, for points outside its negative. The value
/// changes by no more than the point moves, so samples on a grid bound it everywhere.
class SignedDistance {
 public:
  /// Samples a region's distances. O(n g) for n edges and g samples at worst, about n + g as a
  /// rule.
  explicit SignedDistance(const PolygonSet& region);

  /// At most the signed distance of any point within 2^-45 of its coordinates' magnitude.
  double below(double x, double y) const;

  /// Discs that certainly lie inside the region, largest first; earlier discs do not cover their
  /// centres.
  std::vector<Disc> inscribed_discs(std::size_t count) const;

 private:
  struct Edge {
    double x0, y0, x1, y1;
  };
  static std::vector<Edge> edges_of(const PolygonSet& region);
  void lay_grid(const std::vector<Edge>& edges);
  void measure(const std::vector<Edge>& edges);
  void mark_outside(const std::vector<Edge>& edges);
  double& sample(std::size_t column, std::size_t row) { return samples_[row * columns_ + column]; }

  std::size_t columns_ = 0, rows_ = 0;
  double left_ = 0, bottom_ = 0, spacing_ = 1, over_spacing_ = 1;
  double error_ = 0;  // of a sample, and of a query
  std::vector<double> samples_;
};

}  // namespace minkref::inline plane
