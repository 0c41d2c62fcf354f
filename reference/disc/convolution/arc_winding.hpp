// Winding numbers of the faces of a convolution with a disc.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/convolution/arc_arrangement.hpp"

namespace minkref::inline disc {

/// The unbounded face is one of them. A face may have several cycles.
struct ArcFaces {
  std::vector<std::uint32_t> of_cycle;
  std::vector<int> winding;  ///< by face
};

/// Winding numbers about each cycle are counted from piece to piece, and from one connected part of
/// the arrangement to the next along a horizontal ray, at a height at which there is no node.
/// Exact. O((n + k) log n), and for each part the pieces at its height. Throws std::logic_error if
/// two ways to a face tell different numbers or one is negative, which would be a fault.
ArcFaces arc_faces(const ArcArrangement& arrangement);

}  // namespace minkref::inline disc
