// P ⊕ ρD at one radius, from the winding numbers of the disc convolution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/disc/distance/static_offset.hpp"

namespace minkref::inline disc {

struct ArcConvolution {
  StaticOffset offset;
  /// By piece: the component of the sum's interior on the piece's left.
  std::vector<std::uint32_t> component_of;
  std::size_t components = 0;
  std::size_t holes = 0;  ///< bounded components of the complement
};

/// The boundary of the faces with a positive winding number (Behar & Lien 2012, Sec. 3 and
/// Appendix), for a valid polygon set, a point or a segment, and squared_radius > 0. The function
/// asks for no distance from P, only where curves of the convolution meet. It shares with
/// static_offset only numbers and the offset curves that name both answers. Exact. O((n + k) log n)
/// for k pairs of curves with boxes that overlap; slits take O(h n) for h holes. Throws
/// std::logic_error if winding numbers do not add up, which would be a fault.
ArcConvolution arc_convolution(const PolygonSet& P, const Rational& squared_radius);

}  // namespace minkref::inline disc
