// Cuts the boundary of P at the corners' feet: visible parts bound the sum at a radius, hidden
// parts lie before features.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A radius for features: their points are nearer to P.
struct FeatureRadius {
  std::uint32_t level;              ///< counts smaller event radii
  bool at_event;                    ///< this radius equals the next event radius
  std::optional<Rational> squared;  ///< within the curves' frame; none: infinite
};

/// Takes a squared radius above 0, or none for infinity. Exact.
FeatureRadius feature_radius(const DiscIndex& index, const std::optional<Rational>& squared_radius);

/// From a corner's foot to the next corner's foot along a walk.
struct BoundaryPart {
  std::uint32_t walk;
  std::uint32_t from, to;               ///< diagram halves with the corners
  std::vector<std::uint32_t> vertices;  ///< passed between, as features

  bool operator==(const BoundaryPart&) const = default;
};

/// A closed curve: consecutive parts, joined through chords between both feet of each corner. No
/// parts: a whole walk.
struct PartRing {
  std::vector<std::uint32_t> parts;
  std::uint32_t walk;
};

struct BoundaryParts {
  std::vector<BoundaryPart> hidden, visible;
  /// Hidden closed curves have features on the right; visible ones have P and all features on the
  /// left. Whole walks come last.
  std::vector<PartRing> hidden_rings, visible_rings;
};

/// Finds all parts below a level. Exact: compares whole numbers. O(n).
BoundaryParts boundary_parts(const DiscIndex& index, std::uint32_t level);

/// Lists a whole walk's vertices, as features.
std::vector<std::uint32_t> walk_vertices(const DiscIndex& index, std::uint32_t walk);

}  // namespace minkref::inline disc
