// Winding numbers for the faces of a disc convolution.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/convolution/arc_arrangement.hpp"

namespace minkref::inline disc {

/// One face is unbounded. A face may have several cycles.
struct ArcFaces {
  std::vector<std::uint32_t> of_cycle;
  std::vector<int> winding;  ///< by face
};

/// Counts winding numbers from piece to piece about each cycle, and from one connected part of the
/// arrangement to the next along a horizontal ray, at a height without nodes. Exact. O((n + k) log
/// n), and for each part the pieces at its height. Throws std::logic_error if two ways to a face
/// give different numbers or a number is negative, which would be a fault.
ArcFaces arc_faces(const ArcArrangement& arrangement);

}  // namespace minkref::inline disc
