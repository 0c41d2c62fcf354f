// The reduced convolution of P with a disc, without numbers: segments, arcs, and the nodes at which
// they join. The same at every scale.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/disc/pairs/offset_feature.hpp"

namespace minkref::inline disc {

/// A segment, or the part of an arc within a quadrant, between two nodes. Neither coordinate turns
/// within it.
struct CurvePart {
  std::uint32_t feature;
  int quadrant;  ///< of the normals; -1 of a segment
  std::uint32_t from, to;
};

/// A feature's end, or the place of an arc with a normal along an axis.
struct FrameNode {
  std::uint32_t feature;
  int end;         ///< -1 for a place within an arc
  Direction axis;  ///< of such a place
};

struct CurveFrame {
  OffsetCurves curves;
  std::vector<OffsetFeature> features;
  std::vector<FrameNode> nodes;
  std::vector<CurvePart> parts;
  std::vector<std::uint32_t> first_part;           ///< by feature, and the number of parts
  std::vector<std::array<std::uint32_t, 2>> ends;  ///< by feature: the nodes at its ends

  /// Whether two features share an end: nothing else is theirs at any scale.
  bool are_joined(std::uint32_t a, std::uint32_t b) const {
    return ends[a][0] == ends[b][1] || ends[a][1] == ends[b][0];
  }
};

/// The frame of a valid polygon set or a segment. `are_joined`: whether a segment and an arc share
/// a node where one ends and the other begins. O(n log n).
CurveFrame curve_frame(const PolygonSet& P, bool are_joined);

/// The quadrant, from 0, that starts at a normal and goes on counter-clockwise.
int quadrant_from(const Direction& normal);

}  // namespace minkref::inline disc
