#include "reference/near/separation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace minkref {
namespace {

constexpr int most_guesses = 16;
constexpr double unbounded = std::numeric_limits<double>::infinity();

NearVector difference(const NearVector& a, const NearVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// In the same direction, its longest coordinate 1 or -1. Nothing if too short.
std::optional<NearVector> normalized(const NearVector& v) {
  const double longest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  if (!(longest > 1e-290) || !(longest < unbounded)) return std::nullopt;
  return NearVector{v[0] / longest, v[1] / longest, v[2] / longest};
}

class SeparationSearch {
 public:
  SeparationSearch(const std::vector<NearPoint>& points, const Cluster& first,
                   const Cluster& second)
      : points_(points), first_(first), second_(second) {}

  bool run() {
    if (!find_common()) return false;
    std::vector<NearVector> hull;
    std::optional<NearVector> normal = normalized(first_guess());
    NearVector near{};
    for (int guess = 0; guess < most_guesses && normal; ++guess) {
      if (common_ ? is_cone_apart(*normal) : is_apart(*normal)) return true;
      if (guess > 0 && dot(near, near) - dot(near, support_) <= 1e-9 * dot(near, near)) {
        return false;  // it is the nearest point, and does not separate
      }
      hull.push_back(support_);
      near = nearest_in_hull(hull);
      normal = normalized(near);
      if (hull.empty()) return false;
    }
    return false;
  }

 private:
  /// False where the clusters have two points in common or more.
  bool find_common() {
    for (std::size_t i = 0, j = 0; i < first_.size() && j < second_.size();) {
      if (first_[i] == second_[j]) {
        if (common_) return false;
        common_ = first_[i];
        ++i, ++j;
      } else {
        first_[i] < second_[j] ? ++i : ++j;
      }
    }
    return true;
  }

  NearVector mean(const Cluster& cluster) const {
    NearVector sum{};
    for (const std::uint32_t p : cluster) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += points_[p].low[k] / static_cast<double>(cluster.size());
      }
    }
    return sum;
  }
  NearVector first_guess() const { return difference(mean(first_), mean(second_)); }

  /// How far p lies above o along the normal, whose coordinates are at most 1, and by how much that
  /// may be wrong. A difference of doubles is rounded once, a product twice, their sum twice more.
  struct Height {
    double value, error;
  };
  Height height(const NearVector& normal, const NearPoint& p, const NearPoint& o) const {
    double value = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double step = normal[k] * (p.low[k] - o.low[k]);
      value += step;
      size += std::fabs(step);
    }
    return {value, 0x1p-49 * size + 4 * (p.width + o.width) + 1e-300};
  }

  /// Sets the support: the difference of the points of both that are nearest along the normal.
  bool is_apart(const NearVector& normal) {
    const NearPoint& origin = points_[first_[0]];
    double least = unbounded, most = -unbounded, certainly_above = unbounded,
           certainly_below = -unbounded;
    std::uint32_t lowest = first_[0], highest = second_[0];
    for (const std::uint32_t p : first_) {
      const Height at = height(normal, points_[p], origin);
      certainly_above = std::min(certainly_above, at.value - at.error);
      if (at.value < least) least = at.value, lowest = p;
    }
    for (const std::uint32_t p : second_) {
      const Height at = height(normal, points_[p], origin);
      certainly_below = std::max(certainly_below, at.value + at.error);
      if (at.value > most) most = at.value, highest = p;
    }
    if (certainly_above > certainly_below) return true;
    support_ = difference(points_[lowest].low, points_[highest].low);
    return false;
  }

  /// The same of the two cones from the common point; the support is of unit length.
  bool is_cone_apart(const NearVector& normal) {
    const NearPoint& apex = points_[*common_];
    bool is_certain = true;
    double least = unbounded;
    const auto look_at = [&](const Cluster& cluster, double side) {
      for (const std::uint32_t p : cluster) {
        if (p == *common_) continue;
        const Height at = height(normal, points_[p], apex);
        is_certain = is_certain && side * at.value > at.error;
        NearVector way = difference(points_[p].low, apex.low);
        const double length = std::sqrt(dot(way, way));
        if (!(length > 0)) continue;
        const double value = side * at.value / length;
        if (value >= least) continue;
        least = value;
        for (std::size_t k = 0; k < 3; ++k) support_[k] = side * way[k] / length;
      }
    };
    look_at(first_, 1);
    look_at(second_, -1);
    return is_certain;
  }

  const std::vector<NearPoint>& points_;
  const Cluster &first_, &second_;
  std::optional<std::uint32_t> common_;
  NearVector support_{};
};

}  // namespace

bool are_apart_but_for_a_common_point(const std::vector<NearPoint>& points, const Cluster& first,
                                      const Cluster& second) {
  if (first.empty() || second.empty()) return true;
  return SeparationSearch(points, first, second).run();
}

}  // namespace minkref
