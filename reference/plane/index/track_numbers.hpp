// Tracks at a scale in exact numbers.
#pragma once

#include "reference/plane/index/index_rings.hpp"

namespace minkref::inline plane {

/// Fills result.numbers and .words, for tracks from a column with five integers each, at most
/// `bits` bits long. Exact. Some 5 ns a vertex if all numbers fit into 128 bits, else some 0.3 us.
void homogeneous_numbers(const IntegerColumn& tracks, std::uint64_t bits,
                         const std::vector<std::uint32_t>& which, const Rational& scale,
                         HomogeneousRings& result);

/// Reduces homogeneous numbers. Exact. Some 0.3 us a vertex.
void reduced_numbers(const HomogeneousRings& from, RationalRings& result);

}  // namespace minkref::inline plane
