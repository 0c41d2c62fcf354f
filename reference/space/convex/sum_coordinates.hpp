// The exact coordinates of vertex sums, over one denominator for each axis.
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

/// Numerators as the narrowest integers that hold them all: 64 bits, 128 bits, or unlimited.
using Numerators =
    std::variant<std::vector<WordVector>, std::vector<WideVector>, std::vector<IntegerVector>>;

/// Point k of a list is, along axis i, `numerators[k][i] / denominators[i]`.
struct HomogeneousPoints {
  IntegerVector denominators{1, 1, 1};
  Numerators numerators;
};

/// Computes s_i p_i + q_i for all pairs, in order. Exact. Writes into `points` and reuses the
/// memory there. O(m + n + k).
void sum_coordinates(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const SumVertices& vertices, HomogeneousPoints& points);

/// The numerators as word vectors, if all are short enough.
std::optional<std::vector<WordVector>> in_words(const HomogeneousPoints& points);
std::vector<IntegerVector> in_integers(const HomogeneousPoints& points);
std::size_t count(const HomogeneousPoints& points);

}  // namespace minkref::inline space
