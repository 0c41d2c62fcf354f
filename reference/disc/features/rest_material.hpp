// The rest material at a radius: what a closing with the disc adds to P.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/features/rest_arcs.hpp"

namespace minkref::inline disc {

/// A piece of the boundary: a hidden part of the boundary of P, or a free arc.
struct RestPiece {
  bool is_arc;
  std::uint32_t number;
};

/// Pieces one after the other, with the rest on the right; none: a whole walk.
struct RestRing {
  std::vector<RestPiece> pieces;
  std::uint32_t walk;
};

/// The rest within one feature's region.
struct FeatureRest {
  std::vector<RestRing> rings;
  std::size_t components;  ///< of the interior
};

/// closing(P) \ P, where the closing (P ⊕ ρD) ⊖ ρD holds all points that no disc of radius ρ
/// outside of P reaches. It consists of the regions without the open discs about the corners of
/// their own features: a disc that comes into a region through a chord covers there no more than
/// the disc about the chord's corner does (docs/disc.md).
struct RestMaterial {
  std::vector<FreeArc> arcs;
  std::vector<FeatureRest> features;  ///< as FeatureRegions has them
};

/// Finds the rest at a finite radius. Exact. O(n log n), and O(k^2) comparisons of doubles for k
/// corners of one feature.
RestMaterial rest_material(const RegionOutlines& outlines);

}  // namespace minkref::inline disc
