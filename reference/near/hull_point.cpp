#include "reference/near/hull_point.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace minkref {
namespace {

using Weights = std::array<double, 4>;

double determinant(const std::array<NearVector, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// The weights, none negative, of the point of the flat through these points that is nearest to the
/// origin.
std::optional<Weights> weights_in(const std::vector<NearVector>& points, std::size_t count) {
  // With edges e from the last point p: sum over j of (e_i · e_j) w_j = -e_i · p. Unit rows of the
  // rest keep the system one of three.
  std::array<NearVector, 3> edges{}, system{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  NearVector right{};
  const NearVector& last = points[count - 1];
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) edges[i][k] = points[i][k] - last[k];
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t j = 0; j + 1 < count; ++j) system[i][j] = dot(edges[i], edges[j]);
    right[i] = -dot(edges[i], last);
  }
  const double whole = determinant(system);
  if (!(whole > 0)) return std::nullopt;
  Weights result{};
  double rest = 1;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    std::array<NearVector, 3> changed = system;
    for (std::size_t j = 0; j < 3; ++j) changed[j][i] = right[j];
    result[i] = determinant(changed) / whole;
    if (!(result[i] >= 0)) return std::nullopt;
    rest -= result[i];
  }
  if (rest < 0) return std::nullopt;
  result[count - 1] = rest;
  return result;
}

}  // namespace

NearVector nearest_in_hull(std::vector<NearVector>& points) {
  double least = std::numeric_limits<double>::infinity();
  NearVector nearest = points.back();
  std::vector<NearVector> kept, chosen;
  for (unsigned subset = 1; subset < 1U << points.size(); ++subset) {
    chosen.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if ((subset >> k & 1U) != 0) chosen.push_back(points[k]);
    }
    const std::optional<Weights> weights = weights_in(chosen, chosen.size());
    if (!weights) continue;
    if (chosen.size() == 4) return {0, 0, 0};
    NearVector point{};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) point[k] += (*weights)[i] * chosen[i][k];
    }
    if (dot(point, point) >= least) continue;
    least = dot(point, point);
    nearest = point;
    kept = chosen;
  }
  points = std::move(kept);
  return nearest;
}

}  // namespace minkref
