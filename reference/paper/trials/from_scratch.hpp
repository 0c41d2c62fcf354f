// The dynamic arrangement and sum held against those computed from scratch.
#pragma once

#include <string>

#include "reference/plane/dynamic/dynamic_sum.hpp"

namespace minkref {

/// Compares the arrangement and the sum where `dynamic` stands with the static ones of the same
/// operands at that scale: the exact points on every edge and their order; the canonical form,
/// components and holes. Returns a difference, empty if there is none. Exact. O((N + k) log N).
std::string difference_from_scratch(DynamicSum& dynamic, const PolygonSet& P, const PolygonSet& Q);

}  // namespace minkref
