// The contents of an index's columns.
#pragma once

#include "reference/plane/index/index_image.hpp"

namespace minkref::inline plane {

inline constexpr std::uint32_t no_event = 0xffffffffU;

struct IndexCounts {
  std::uint64_t s_edges = 0, t_edges = 0;
  std::uint64_t meeting_pairs = 0, pairs_inside = 0;
  std::uint64_t pieces_in_all = 0, faces_tested = 0, pieces = 0;
  std::uint64_t track_bits = 0;  ///< of the longest integer of a track, with its sign
};
struct IndexEdge {
  std::uint32_t is_t = 0, edge_ring = 0, edge = 0, vertex_ring = 0, vertex = 0;
};
struct IndexTrack {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
struct IndexLink {
  std::uint32_t from = 0, to = 0, edge = 0, first = 0, last = 0;
};
struct IndexBucket {
  std::uint32_t first = 0, last = 0;  ///< intervals
  std::uint32_t entry_begin = 0, entry_end = 0, ring_begin = 0, ring_end = 0;
};
/// A corner, and the convolution edge under the side behind the corner.
struct IndexEntry {
  std::uint32_t first = 0, last = 0;  ///< intervals
  std::uint32_t track = 0, edge = 0;
};
struct IndexRing {
  std::uint32_t hole = 0, component = 0, is_hole = 0;
};
/// a0 + s a1 + s^2 a2, each within an ulp and `error` of the true one.
struct IndexArea {
  double a0 = 0, a1 = 0, a2 = 0, error = 0;
};
/// Counts from an interval on; `_at`: at the event that begins the interval.
struct IndexFeatureCount {
  std::uint32_t interval = 0, holes = 0, components = 0, holes_at = 0, components_at = 0;
};
struct IndexMerged {
  std::uint32_t track = 0, stands_for = 0;
};
struct IndexPiece {
  std::uint32_t from = 0, to = 0, edge = 0, before = 0, after = 0;
};
struct IndexAtEvent {
  std::uint32_t merged = 0, pieces = 0;  ///< where its own begin
  std::uint32_t is_plain = 0;            ///< its rings equal the rings below, without empty sides
};
struct IndexFeature {
  std::uint32_t born = no_event, died = no_event;
};
struct IndexTopologyEvent {
  std::uint32_t event = 0, kind = 0, change = 0, parts = 0;
  std::uint32_t before = 0, after = 0, end = 0;  ///< where its lists begin
};
struct IndexBoundaryEvent {
  std::uint32_t event = 0, change = 0, edges = 0, end = 0;
};

/// All columns of an image. As long-lived as the image.
struct IndexColumns {
  IntegerColumn window;
  IndexCounts counts;
  std::span<const std::uint32_t> rings_of_P, rings_of_Q;
  IntegerColumn coordinates_of_P, coordinates_of_Q;
  std::span<const IndexEdge> edges;
  std::span<const std::uint32_t> directions;
  IntegerColumn events;
  std::span<const double> events_in_doubles;
  IntegerColumn tracks;
  std::span<const IndexTrack> tracks_in_doubles;
  std::span<const IndexLink> links;
  std::span<const std::uint32_t> bucket_of;
  std::span<const IndexBucket> buckets;
  std::span<const IndexEntry> entries;
  std::span<const std::uint32_t> ring_ends;
  std::span<const IndexRing> ring_features;
  std::span<const IndexArea> areas;
  std::span<const IndexFeatureCount> feature_counts;
  std::span<const IndexMerged> merged;
  std::span<const IndexPiece> pieces;
  std::span<const IndexAtEvent> at_events;
  std::span<const IndexFeature> holes, components;
  std::span<const IndexTopologyEvent> topology;
  std::span<const IndexBoundaryEvent> boundary;
  std::span<const std::uint32_t> lists;
  IntegerColumn places;

  /// Checks every number that refers to another column: no query reads beyond a column. Throws
  /// BadInput ("damaged-index"). O(bytes).
  explicit IndexColumns(const IndexImage& image);
};

}  // namespace minkref::inline plane
