// The convolution by each reading of "between" in the compatibility rule (Behar & Lien 2012, Sec.
// 3).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// Which ends of a turn belong to it; the paper leaves it open. They differ where an edge of P and
/// an edge of Q have one direction.
enum class Between : std::uint8_t {
  half_open,  ///< [in, out) at vertices of Q, (in, out] at vertices of P: the corrected rule
  open,       ///< no end: part of the boundary of the sum may be lost
  closed,     ///< both ends: pieces on the boundary of the sum may be there twice
};

/// The convolution, full or reduced, by one of these readings; S-edges first. At straight vertices
/// there is nothing by any of them. `half_open` gives full_convolution or reduced_convolution, a
/// part of it is `open`, and it is a part of `closed`. Exact.
std::vector<ConvolutionEdge> convolution(const PolygonSet& P, const PolygonSet& Q, bool full,
                                         Between between);

}  // namespace minkref::inline plane
