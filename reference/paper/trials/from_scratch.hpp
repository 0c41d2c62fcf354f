// The dynamic arrangement and sum, compared with an arrangement and a sum from scratch.
#pragma once

#include <string>

#include "reference/plane/dynamic/dynamic_sum.hpp"

namespace minkref {

/// Compares the arrangement and the sum at the current scale of `dynamic` with the static results
/// for the same operands: the exact points on every edge and their order; winding numbers, if they
/// are kept; the canonical form, components and holes. Returns a difference, empty if none exists.
/// Exact. O((N + k) log N).
std::string difference_from_scratch(DynamicSum& dynamic, const PolygonSet& P, const PolygonSet& Q);

}  // namespace minkref
