// All bridges at a radius as doubles with error bounds, for many radii (Behar & Lien 2012, Sec.
// 8.2).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/features/barcode.hpp"

namespace minkref::inline disc {

/// A bridge's ends, the left one first as seen from its feature, and the centre of its empty disc,
/// each coordinate off by at most `error`. `feature`: the tree's node.
struct NearBridge {
  double from_x, from_y, to_x, to_y, x, y, error;
  std::uint32_t feature, bar;
};

/// Reads bridges at any radius off the index and the tree, which must outlive it.
class NearBridges {
 public:
  /// O(n).
  NearBridges(const DiscIndex& index, const MergeTree& tree, const Barcode& codes);

  /// All bridges at a radius, features ascending; at an event's own radius those just below. The
  /// features are exact. Coordinates err by at most 2^-41 of the size of P and of the radius, and
  /// 2^-49 of the coordinates themselves. O(n), some nanoseconds for each part of the diagram.
  void at(double radius, std::vector<NearBridge>& found) const;

 private:
  /// A vertex of P; or the line u · x = level, with a unit vector u.
  struct Feature {
    bool is_point;
    double x, y, level;
  };
  struct Rising {
    std::uint32_t half, low, high, own, across;
  };
  /// A tree node lives from its radius to its parent's; a root never.
  struct Life {
    std::uint32_t from, to, parent;
  };
  static Feature rounded(const OffsetCurves& curves, std::uint32_t feature);
  BoundedPoint foot(const Feature& feature, const BoundedPoint& centre) const;

  const DiscIndex& index_;
  const Barcode& codes_;
  std::vector<Feature> features_;
  std::vector<Rising> rising_;         ///< by tree node
  std::vector<std::uint32_t> starts_;  ///< of nodes
  std::vector<Life> lives_;
  double scale_ = 1, x_ = 0, y_ = 0, origin_error_ = 0;  ///< from the frame of the curves to P's
};

}  // namespace minkref::inline disc
