// The outer ring around a hole.
#pragma once

#include <cstddef>
#include <vector>

#include "formats/input.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// Whether no vertex and no midpoint of an edge of `inner` lies strictly outside `outer`, nor the
/// start of its first edge up to the first contact: for rings that touch at points only, `inner`
/// then lies within the closed region of `outer`. Exact. O(m n), `steps` counts the edges visited.
bool lies_inside(const Ring& inner, const Ring& outer, std::size_t& steps);

/// The index of the smallest outer ring around each hole. A lone outer ring takes all holes,
/// and one of many each hole that rays give it, untested (`validate` tests them). `outers` and
/// `holes` must have three vertices each, or more. Throws BadInput ("hole-outside", at
/// `places[hole]`), LimitExceeded ("too-much-work").
std::vector<std::size_t> containing_outers(const std::vector<const Ring*>& outers,
                                           const std::vector<const Ring*>& holes,
                                           const std::vector<Place>& places, const Input& input);

}  // namespace minkref
