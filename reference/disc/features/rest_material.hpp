// The rest material at a radius: a closing with the disc adds this to P.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/features/rest_arcs.hpp"

namespace minkref::inline disc {

/// A boundary piece: a hidden part, or a free arc.
struct RestPiece {
  bool is_arc;
  std::uint32_t number;
};

/// Consecutive pieces, with the rest on the right; none: a whole walk.
struct RestRing {
  std::vector<RestPiece> pieces;
  std::uint32_t walk;
};

/// The rest within a feature's region.
struct FeatureRest {
  std::vector<RestRing> rings;
  std::size_t components;  ///< the interior's
};

/// closing(P) \ P: no disc outside P with the radius ρ reaches these points. Each region loses the
/// open discs about the feature's own corners. A disc entering a region through a chord covers no
/// more than the disc about the chord's corner (docs/features.md).
struct RestMaterial {
  std::vector<FreeArc> arcs;
  std::vector<FeatureRest> features;  ///< like FeatureRegions::features
  /// Corners of one feature whose open discs overlap inside the region.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps;
};

/// Finds the rest at a finite radius. Exact. O(n log n), and O(k^2) double comparisons for k
/// corners around a feature.
RestMaterial rest_material(const RegionOutlines& outlines);

}  // namespace minkref::inline disc
