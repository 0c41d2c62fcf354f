// Planes between clusters of points, proved in floating point.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/near/hull_point.hpp"

namespace minkref {

/// A point somewhere in a cube about doubles. Numbers given to `separation` are at most 2^100, the
/// width apart, which may be infinite.
struct NearPoint {
  NearVector low{};
  double width = 0;  ///< no coordinate is farther than this from that of `low`
};

/// Points by their numbers, ascending, each once.
using Cluster = std::vector<std::uint32_t>;

/// Whether it was proved that the hulls of two clusters are apart, or have one point alone in
/// common, one that belongs to both: a plane has the rest strictly on its two sides. False says
/// nothing, and is at once the answer where two points belong to both. Planes are guessed by
/// distances between hulls (Gilbert, Johnson and Keerthi 1988), of their cones from the common
/// point where there is one. Linear in the points, for each of a few guesses.
bool are_apart_but_for_a_common_point(const std::vector<NearPoint>& points, const Cluster& first,
                                      const Cluster& second);

}  // namespace minkref
