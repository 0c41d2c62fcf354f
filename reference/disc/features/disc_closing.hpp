// The closing by a disc: P with its rest material, as rings of lines and arcs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/disc/features/rest_material.hpp"

namespace minkref::inline disc {

/// A free arc, counter-clockwise, or a visible part of P's boundary, backwards.
struct ClosingPiece {
  bool is_arc;
  std::uint32_t number;
};

/// Consecutive pieces, with the closing on the right; none: a whole walk, backwards.
struct ClosingRing {
  std::vector<ClosingPiece> pieces;
  std::uint32_t walk;
};

/// The set to close: P in canonical form, or what is outside of it within a box (outside.hpp).
PolygonSet set_to_close(const PolygonSet& P, bool inward);

struct DiscClosing {
  std::vector<ClosingRing> rings;  ///< whole walks last
  std::size_t components;          ///< the interior's
  std::size_t holes;               ///< bounded components of the complement
};

/// Unites P and its rest material. P: in canonical form. Exact, beside an event's radius and just
/// below: all open discs of the radius that miss P are taken away (docs/erosion.md). O(n log n)
/// after rest_material, and more where the rest within one feature falls apart around an island.
/// Throws LimitExceeded ("nested-rest") if intervals do not tell the part next to an island.
DiscClosing disc_closing(const RegionOutlines& outlines, const RestMaterial& rest);

}  // namespace minkref::inline disc
