// The boundary at one scale, ring by ring, with the form that the caller chooses.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/index/integer_column.hpp"
#include "reference/plane/index/ring_order.hpp"

namespace minkref::inline plane {

/// Unordered rings, one after the other, outer rings counter-clockwise and holes clockwise, without
/// straight vertices. Filling the same object twice reuses its memory.
struct RingShape {
  std::vector<std::uint32_t> ring_ends;  ///< behind the last vertex of each ring
  /// The hole and the component that each ring bounds, as on the timeline; at an event with
  /// touching rings, fresh numbers for parts of the timeline's features.
  std::vector<RingFeatures> rings;
  /// For each vertex a convolution edge under the side behind the vertex, by its index within
  /// ScaleIndex::edges.
  std::vector<std::uint32_t> edges;
};

/// Vertices as tracks of the index: the functions of the scale themselves.
struct TrackRings : RingShape {
  std::vector<std::uint32_t> tracks;
};

/// Each coordinate has an error of at most `error`.
struct RoundedRings : RingShape {
  std::vector<double> x, y;
  double error = 0;
};

/// Vertices as (X / W, Y / W), W > 0, not in lowest terms: three integers each.
struct HomogeneousRings : RingShape {
  std::uint32_t words = 1;  ///< of each integer, as for IntegerColumn
  std::vector<std::uint64_t> numbers;
  IntegerColumn column() const { return {words, numbers}; }
};

/// Vertices as (x, y) in lowest terms: four integers each, x num, x den, y num, y den.
struct RationalRings : RingShape {
  std::uint32_t words = 1;
  std::vector<std::uint64_t> numbers;
  IntegerColumn column() const { return {words, numbers}; }
};

}  // namespace minkref::inline plane
