// The exact coordinates of sums of vertices, over one denominator for each axis.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "reference/convex/convex_polyhedron.hpp"
#include "reference/convex/sum_vertices.hpp"

namespace minkref {

__extension__ using Wide = __int128;

/// Numerators in the narrowest integers that hold all of them: 64 bits, 128 bits, or any.
using Numerators = std::variant<std::vector<std::array<std::int64_t, 3>>,
                                std::vector<std::array<Wide, 3>>, std::vector<IntegerVector>>;

/// Point k of a list is, along axis i, `numerators[k][i] / denominators[i]`.
struct HomogeneousPoints {
  IntegerVector denominators{1, 1, 1};
  Numerators numerators;
};

/// s_i p_i + q_i for all pairs, in their order. Exact. Writes into `points`, whose memory is used
/// again. O(m + n + k).
void sum_coordinates(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const SumVertices& vertices, HomogeneousPoints& points);

/// One numerator as an integer.
Integer numerator_at(const HomogeneousPoints& points, std::size_t point, std::size_t axis);
std::size_t count(const HomogeneousPoints& points);

}  // namespace minkref
