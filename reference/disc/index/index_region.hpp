// The canonical form of P ⊕ ρD read off the index.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/curves/offset_form.hpp"
#include "reference/disc/index/offset_history.hpp"

namespace minkref::inline disc {

/// Components and holes at all radii of a gap.
struct IndexRegion {
  OffsetForm form;  ///< canonical
  std::size_t holes;
};

/// Reads regions off an index. Nothing touches between events, so each ring is simple, and one ring
/// surrounds each bounded component of the complement.
class IndexRegions {
 public:
  /// All arguments must outlive the object. `curves` holds the unmodified curves of P: names for
  /// the form.
  IndexRegions(const DiscIndex& index, const OffsetHistory& history, const OffsetCurves& curves)
      : index_(index), history_(history), curves_(curves) {}

  /// Exact. O(n log n).
  IndexRegion at(std::uint32_t gap) const;

 private:
  std::uint32_t polygon_of(std::uint32_t side) const;
  std::uint32_t outer_ring(std::uint32_t polygon, const IndexBoundary& boundary) const;
  std::vector<std::uint32_t> curves_of(const IndexBoundary& boundary, const IndexRing& ring) const;

  const DiscIndex& index_;
  const OffsetHistory& history_;
  const OffsetCurves& curves_;
};

}  // namespace minkref::inline disc
