// Codes that separate a cell from all sums of pieces.
#pragma once

#include "certify/plane/cell_complex.hpp"

namespace minkref::certify {

/// Entries that split a pair's node; all other entries are separating normals.
inline constexpr std::int64_t split_P = -1, split_Q = -2;

/// The code of a hull of corners: pairs of nodes from the roots on, the first child first; numbers
/// from 0 on are normals n with n * corner >= n * x for all x in the pair's sum. Throws
/// std::logic_error if it meets the interior of the sum. Exact. O(k) for k entries of the code,
/// with some tens of normals tried for each.
std::vector<std::int64_t> separating_code(const CellComplex& complex,
                                          const std::vector<std::uint32_t>& corners);

}  // namespace minkref::certify
