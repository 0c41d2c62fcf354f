// The closed curves around features' regions and around the alpha-shape, exactly, and their areas.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/bridge.hpp"
#include "reference/disc/features/feature_regions.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/root_text.hpp"

namespace minkref::inline disc {

/// A corner of the sum's boundary and its bridge, within the curves' frame.
struct CornerBridge {
  std::uint32_t half;               ///< that rises; hidden parts end there
  std::optional<RootPoint> corner;  ///< none at infinity
  Chord<RootNumber> chord;          ///< from the half's own side
};

/// A step along a closed curve. Both ends lie on the line of an edge of P, or belong to one field.
struct OutlineStep {
  RootPoint from, to;
  std::uint32_t edge;  ///< of P; none
  bool is_chord;
};

class RegionOutlines {
 public:
  /// Both must outlive the object. Finds all bridges from roots: some ten microseconds each.
  RegionOutlines(const Bridges& bridges, const FeatureRegions& regions);

  const DiscIndex& index() const { return bridges_.index(); }
  const FeatureRegions& regions() const { return regions_; }
  /// By hidden part: the bridge at its end.
  const std::vector<CornerBridge>& corners() const { return corners_; }
  /// The foot on a half that carries a corner.
  const RootPoint& foot(std::uint32_t half) const;
  /// A corner and its feet in numbers that take operands of any fields.
  Vector<Surd> surd_corner(std::uint32_t number) const;
  Chord<Surd> surd_chord(std::uint32_t number) const;

  /// Steps along a part, without the chord that follows it.
  void add_part(const BoundaryPart& part, std::vector<OutlineStep>& steps) const;
  /// All steps of a closed curve of hidden parts, or of visible parts.
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

/// An area with its terms: `bounds` are two neighbouring doubles around the area, or one double
/// twice.
struct OutlineArea {
  RootTerms terms;
  Interval bounds;
};

/// Areas of a feature's region and of a whole alpha-shape, in coordinates of P. Exact; one ring's
/// area counts with its orientation. Throws LimitExceeded ("too-many-digits") if 2^14 bits do not
/// tell an irrational number from a double. O(n) roots.
OutlineArea region_area(const RegionOutlines& outlines, const FeatureRegion& feature);
OutlineArea ring_area(const RegionOutlines& outlines, const PartRing& ring, bool is_hidden);
OutlineArea shape_area(const RegionOutlines& outlines);

/// Adds half the cross product of a step's ends, times a factor.
void add_cross(const DiscIndex& index, const OutlineStep& step, const Rational& factor,
               RootTerms& terms);

}  // namespace minkref::inline disc
