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
  /// 2^-49 of the coordinates themselves. Some nanoseconds for each
  /// bridge.
  void at(double radius, std::vector<NearBridge>& found) const;

 private:
  /// The foot of a place c is base + share (c - (u · c - level) u): a vertex of P, with share 0; or
  /// a point of the line u · x = level, with a unit vector u and share 1. `error`: of the base.
  struct Feature {
    double base_x, base_y, share, x, y, level, error;
  };
  /// A bridge's whole life, with all that a reading needs side by side in memory.
  struct Rising {
    CornerMotion motion;
    Feature own, across;
    std::uint32_t half;
  };
  /// A tree node lives up to its parent's radius; a root for ever.
  struct Life {
    std::uint32_t to, parent;
  };
  /// A bridge with a corner within a span of gaps, and the feature that it is a part of there: a
  /// node alive at the span's start, or one that begins later.
  struct Part {
    std::uint32_t low, high, rising, node;
  };
  static Feature rounded(const OffsetCurves& curves, std::uint32_t feature);
  void part_gaps(const MergeTree& tree, const std::vector<Feature>& features);
  static BoundedPoint foot(const Feature& feature, const BoundedPoint& centre);
  void place(const Rising& own, const FrameRadius& radius, NearBridge& found) const;

  const DiscIndex& index_;
  const Barcode& codes_;
  std::vector<Rising> rising_;  ///< by tree node
  std::vector<Life> lives_;
  std::uint32_t gaps_of_span_ = 1;
  std::vector<std::vector<Part>> spans_;                 ///< by tree node
  double scale_ = 1, x_ = 0, y_ = 0, origin_error_ = 0;  ///< from the frame of the curves to P's
};

}  // namespace minkref::inline disc
