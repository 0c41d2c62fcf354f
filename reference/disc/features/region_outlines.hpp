// Closed curves around features' regions and around the alpha-shape, with exact areas.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/bridge.hpp"
#include "reference/disc/features/feature_regions.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/root_text.hpp"

namespace minkref::inline disc {

/// A boundary corner with its bridge, within the curves' frame.
struct CornerBridge {
  std::uint32_t half;               ///< rising; hidden parts end there
  std::optional<RootPoint> corner;  ///< none at infinity
  Chord<RootNumber> chord;          ///< from the half's own side
};

/// A step along a closed curve. Both ends lie on an edge's line, or share a number field.
struct OutlineStep {
  RootPoint from, to;
  std::uint32_t edge;  ///< none: a shared field
};

class RegionOutlines {
 public:
  /// Both must outlive the object. Finds all bridges from roots: some ten microseconds each.
  RegionOutlines(const Bridges& bridges, const FeatureRegions& regions);

  const DiscIndex& index() const { return bridges_.index(); }
  const FeatureRegions& regions() const { return regions_; }
  /// The bridge at each hidden part's end.
  const std::vector<CornerBridge>& corners() const { return corners_; }
  /// The foot on a half with a corner.
  const RootPoint& foot(std::uint32_t half) const;
  /// A corner and both feet as numbers for mixed fields.
  Vector<Surd> surd_corner(std::uint32_t number) const;
  Chord<Surd> surd_chord(std::uint32_t number) const;

  /// Steps along a part, without the chord that follows it.
  void add_part(const BoundaryPart& part, std::vector<OutlineStep>& steps) const;
  /// All steps along a closed curve.
  std::vector<OutlineStep> outline(const PartRing& ring, bool is_hidden) const;

  /// Converts a point from the frame to the coordinates of P.
  RootPoint placed(const RootPoint& point) const;

 private:
  const Bridges& bridges_;
  const FeatureRegions& regions_;
  BridgeRadius radius_;
  std::vector<CornerBridge> corners_;
  std::vector<std::uint32_t> corner_of_half_;
};

/// An area with exact terms; `bounds`: two neighbouring doubles around the area, or a double twice.
struct OutlineArea {
  RootTerms terms;
  Interval bounds;
};

/// Areas for a feature's region, a ring (signed), and the alpha-shape. Exact. Throws LimitExceeded
/// ("too-many-digits") if 2^14 bits do not tell an irrational number from a double. O(n) roots.
OutlineArea region_area(const RegionOutlines& outlines, const FeatureRegion& feature);
OutlineArea ring_area(const RegionOutlines& outlines, const PartRing& ring, bool is_hidden);
OutlineArea shape_area(const RegionOutlines& outlines);

/// Adds half the ends' cross product, times a factor.
void add_cross(const DiscIndex& index, const OutlineStep& step, const Rational& factor,
               RootTerms& terms);

}  // namespace minkref::inline disc
