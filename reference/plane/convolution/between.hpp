// The convolution by each reading of "between" from the compatibility rule (Behar & Lien 2012, Sec.
// 3).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// The ends that belong to a turn; the paper leaves them open. Readings differ where an edge of P
/// and an edge of Q share a direction.
enum class Between : std::uint8_t {
  half_open,  ///< [in, out) at vertices of Q, (in, out] at vertices of P: the corrected rule
  open,       ///< no end: part of the boundary of the sum may be lost
  closed,     ///< both ends: pieces on the boundary of the sum may be there twice
};

/// The convolution, full or reduced, by a given reading; S-edges first. Straight vertices
/// contribute nothing by any reading. `half_open` gives full_convolution or reduced_convolution,
/// contains `open`, and belongs to `closed`. Exact.
std::vector<ConvolutionEdge> convolution(const PolygonSet& P, const PolygonSet& Q, bool full,
                                         Between between);

}  // namespace minkref::inline plane
