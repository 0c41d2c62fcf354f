// The exact coordinates of sums of vertices, over one denominator for each axis.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "reference/number/int128.hpp"
#include "reference/space/convex/convex_polyhedron.hpp"
#include "reference/space/convex/sum_vertices.hpp"
#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// Numerators in the narrowest integers that hold all of them: 64 bits, 128 bits, or any.
using Numerators =
    std::variant<std::vector<WordVector>, std::vector<WideVector>, std::vector<IntegerVector>>;

/// Point k of a list is, along axis i, `numerators[k][i] / denominators[i]`.
struct HomogeneousPoints {
  IntegerVector denominators{1, 1, 1};
  Numerators numerators;
};

/// s_i p_i + q_i for all pairs, in their order. Exact. Writes into `points`, whose memory is used
/// again. O(m + n + k).
void sum_coordinates(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const SumVertices& vertices, HomogeneousPoints& points);

/// The numerators as word vectors, where all are short enough.
std::optional<std::vector<WordVector>> in_words(const HomogeneousPoints& points);
std::vector<IntegerVector> in_integers(const HomogeneousPoints& points);
std::size_t count(const HomogeneousPoints& points);

}  // namespace minkref::inline space
