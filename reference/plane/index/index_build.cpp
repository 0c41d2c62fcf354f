#include "reference/plane/index/index_build.hpp"

#include <algorithm>

#include "reference/build/build_control.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/critical/scale_window.hpp"
#include "reference/plane/index/area_of_intervals.hpp"
#include "reference/plane/index/corner_entries.hpp"
#include "reference/plane/index/feature_timeline.hpp"
#include "reference/plane/index/index_columns.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {
namespace {

void add_number(std::vector<Integer>& to, const Rational& value) {
  to.push_back(numerator(value));
  to.push_back(denominator(value));
}
void add_point(std::vector<Integer>& to, const Point& point) {
  add_number(to, point.x);
  add_number(to, point.y);
}

class Writing {
 public:
  explicit Writing(const BuildControl& control) : control_(control) {}

  void window(const ScaleWindow& window) {
    std::vector<Integer> numbers;
    for (const auto& bound : {window.from, window.to}) {
      if (bound) {
        add_number(numbers, *bound);
      } else {
        numbers.insert(numbers.end(), {Integer(0), Integer(0)});
      }
    }
    to_.add(Column::window, numbers);
  }

  void operand(const PolygonSet& set, Column rings, Column coordinates) {
    std::vector<std::uint32_t> sizes;
    std::vector<Integer> numbers;
    const auto add = [&](const Ring& ring, bool is_hole) {
      sizes.push_back(static_cast<std::uint32_t>(ring.size()) | (is_hole ? 0x80000000U : 0U));
      for (const Point& p : ring) add_point(numbers, p);
    };
    for (const Polygon& polygon : set.polygons) {
      add(polygon.outer, false);
      for (const Ring& hole : polygon.holes) add(hole, true);
    }
    to_.add(rings, sizes);
    to_.add(coordinates, numbers);
  }

  void swept(const SweptBoundary& swept, const EdgeDirections& directions, std::uint64_t pieces,
             std::uint64_t track_bits) {
    IndexCounts counts;
    std::vector<IndexEdge> edges;
    std::vector<std::uint32_t> ways;
    for (const ConvolutionEdge& e : swept.edges) {
      const bool is_s = e.kind == ConvolutionEdge::Kind::S;
      ++(is_s ? counts.s_edges : counts.t_edges);
      ways.push_back(directions.number(static_cast<std::uint32_t>(ways.size())));
      edges.push_back({is_s ? 0U : 1U, e.edge.ring, e.edge.index, e.vertex.ring, e.vertex.index});
    }
    counts.meeting_pairs = swept.meeting_pairs;
    counts.pairs_inside = swept.pairs_inside;
    counts.pieces_in_all = swept.pieces_in_all;
    counts.faces_tested = swept.faces_tested;
    counts.pieces = pieces;
    counts.track_bits = track_bits;
    to_.add(Column::counts, std::vector<IndexCounts>{counts});
    to_.add(Column::edges, edges);
    to_.add(Column::directions, ways);
  }

  /// Returns the bit length of the tracks' longest integer.
  std::uint64_t moving(const MovingBoundary& boundary) {
    std::vector<Integer> events, tracks;
    std::vector<double> near_events;
    for (const Rational& event : boundary.events) {
      add_number(events, event);
      near_events.push_back(to_double(event));
    }
    std::vector<IndexTrack> near_tracks;
    std::uint64_t bits = 1;
    for (const Track& track : boundary.tracks) {
      control_.look();
      const std::array<const Rational*, 4> parts{&track.a.x, &track.a.y, &track.b.x, &track.b.y};
      Integer den = 1;
      for (const Rational* part : parts) den = lcm(den, denominator(*part));
      for (const Rational* part : parts) {
        tracks.push_back(numerator(*part) * (den / denominator(*part)));
        bits = std::max<std::uint64_t>(bits, signed_bits(tracks.back()));
      }
      bits = std::max<std::uint64_t>(bits, signed_bits(den));
      tracks.push_back(std::move(den));
      near_tracks.push_back(
          {to_double(track.a.x), to_double(track.a.y), to_double(track.b.x), to_double(track.b.y)});
    }
    std::vector<IndexLink> links;
    for (const MovingLink& link : boundary.links) {
      links.push_back({link.from, link.to, link.edge, link.first, link.last});
    }
    to_.add(Column::events, events);
    to_.add(Column::events_in_doubles, near_events);
    to_.add(Column::tracks, tracks);
    to_.add(Column::tracks_in_doubles, near_tracks);
    to_.add(Column::links, links);
    to_.add(Column::areas, areas_of_intervals(boundary, control_));
    return bits;
  }

  void rings(const MovingBoundary& boundary, const EdgeDirections& directions,
             const RingOrder& order) {
    std::vector<std::uint32_t> bucket_of(boundary.events.size() + 1), ring_ends;
    std::vector<IndexBucket> buckets;
    std::vector<IndexEntry> entries;
    std::vector<IndexRing> features;
    std::vector<RingEntry> corners;
    for (const RingBucket& bucket : order.buckets) {
      const auto entry_begin = static_cast<std::uint32_t>(entries.size()),
                 ring_begin = static_cast<std::uint32_t>(ring_ends.size());
      for (std::uint32_t k = bucket.first; k <= bucket.last; ++k) {
        bucket_of[k] = static_cast<std::uint32_t>(buckets.size());
      }
      std::uint32_t begin = 0;
      for (const std::uint32_t end : bucket.ring_ends) {
        control_.look();
        corners.clear();
        append_corners(bucket.entries.data() + begin, bucket.entries.data() + end, boundary,
                       directions, corners);
        for (const RingEntry& corner : corners) {
          const MovingLink& link = boundary.links[corner.link];
          entries.push_back({corner.first, corner.last, link.from, link.edge});
        }
        ring_ends.push_back(static_cast<std::uint32_t>(entries.size()));
        begin = end;
      }
      for (const RingFeatures& f : bucket.features) {
        features.push_back({f.hole, f.component, f.is_hole ? 1U : 0U});
      }
      buckets.push_back({bucket.first, bucket.last, entry_begin,
                         static_cast<std::uint32_t>(entries.size()), ring_begin,
                         static_cast<std::uint32_t>(ring_ends.size())});
    }
    to_.add(Column::bucket_of, bucket_of);
    to_.add(Column::buckets, buckets);
    to_.add(Column::entries, entries);
    to_.add(Column::ring_ends, ring_ends);
    to_.add(Column::ring_features, features);
  }

  void at_events(const std::vector<BoundaryAtEvent>& all, const RingOrder& order) {
    std::vector<IndexMerged> merged;
    std::vector<IndexPiece> pieces;
    std::vector<IndexAtEvent> events;
    const auto begin = [&](bool is_plain) {
      events.push_back({static_cast<std::uint32_t>(merged.size()),
                        static_cast<std::uint32_t>(pieces.size()), is_plain ? 1U : 0U});
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
      control_.look();
      begin(all[k].is_plain() && order.changes[k].same_rings);
      for (const auto& [track, other] : all[k].merged) merged.push_back({track, other});
      for (const BoundaryLink& p : all[k].pieces) {
        pieces.push_back({p.from, p.to, p.edge, p.before, p.after});
      }
    }
    begin(true);
    to_.add(Column::merged, merged);
    to_.add(Column::pieces, pieces);
    to_.add(Column::at_events, events);
  }

  void timeline(const TopologyTimeline& timeline) {
    const auto features = [](const std::vector<Feature>& all) {
      std::vector<IndexFeature> result;
      for (const Feature& f : all) {
        result.push_back({f.born.value_or(no_event), f.died.value_or(no_event)});
      }
      return result;
    };
    std::vector<IndexFeatureCount> counts;
    for (const auto& c : timeline.counts) {
      counts.push_back({c.interval, c.holes, c.components, c.holes_at, c.components_at});
    }
    std::vector<std::uint32_t> lists;
    std::vector<Integer> places;
    const auto end = [&] { return static_cast<std::uint32_t>(lists.size()); };
    const auto add_list = [&](const std::vector<std::uint32_t>& list) {
      const std::uint32_t begin = end();
      lists.insert(lists.end(), list.begin(), list.end());
      return begin;
    };
    std::vector<IndexTopologyEvent> topology;
    for (const TopologyEvent& e : timeline.topology) {
      control_.look();
      const std::uint32_t before = add_list(e.before), after = add_list(e.after);
      topology.push_back({e.group, static_cast<std::uint32_t>(e.kind),
                          static_cast<std::uint32_t>(e.change), static_cast<std::uint32_t>(e.at),
                          before, after, end()});
      add_point(places, e.place);
    }
    std::vector<IndexBoundaryEvent> boundary;
    for (const BoundaryEvent& e : timeline.boundary) {
      control_.look();
      const std::uint32_t edges = add_list(e.edges);
      boundary.push_back({e.group, static_cast<std::uint32_t>(e.change), edges, end()});
      add_point(places, e.place);
    }
    to_.add(Column::holes, features(timeline.holes));
    to_.add(Column::components, features(timeline.components));
    to_.add(Column::feature_counts, counts);
    to_.add(Column::topology, topology);
    to_.add(Column::boundary, boundary);
    to_.add(Column::lists, lists);
    to_.add(Column::places, places);
  }

  IndexImage finish() { return to_.finish(); }

 private:
  const BuildControl& control_;
  IndexImage::Writer to_;
};

/// Indices have 32 bits.
void refuse_too_large(const MovingBoundary& boundary, const RingOrder& order) {
  constexpr std::size_t most = 0x7fffffffU;
  std::size_t entries = 0;
  for (const RingBucket& bucket : order.buckets) entries += 2 * bucket.entries.size();
  if (std::max({boundary.tracks.size(), boundary.links.size(), entries}) > most) {
    throw LimitExceeded("index-too-large", "the index would have more than two billion corners",
                        "take a smaller window of scales or simpler operands");
  }
}

}  // namespace

BuiltIndex built_index(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       const BuildOptions& options, const SweptBefore* before) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, 1);
  refuse_bad_window(window);
  const BuildControl control(options, "the index");
  constexpr auto stage = BuildProgress::Stage::rings;
  constexpr std::uint64_t steps = 5;
  SweptBoundary swept = swept_boundary(P, Q, opened(window), options, before);
  control.report(stage, 0, steps);
  const MovingBoundary boundary = moving_boundary(swept, control);
  control.look_now();
  control.report(stage, 1, steps);
  const EdgeDirections directions = edge_directions(swept.moving);
  const std::vector<BoundaryAtEvent> at_events = boundary_at_events(boundary, directions, control);
  control.look_now();
  control.report(stage, 2, steps);
  RingOrder order = ring_order(swept, boundary, directions, control);
  control.look_now();
  control.report(stage, 3, steps);
  TopologyTimeline timeline;
  if (!boundary.links.empty())
    timeline = feature_timeline(swept, boundary, directions, at_events, order, control);
  control.look_now();
  control.report(stage, 4, steps);
  refuse_too_large(boundary, order);
  Writing writing(control);
  writing.window(window);
  writing.operand(P, Column::rings_of_P, Column::coordinates_of_P);
  writing.operand(Q, Column::rings_of_Q, Column::coordinates_of_Q);
  writing.swept(swept, directions, boundary.pieces, writing.moving(boundary));
  writing.rings(boundary, directions, order);
  writing.at_events(at_events, order);
  writing.timeline(timeline);
  control.look_now();
  IndexImage image = writing.finish();
  swept.edges = {};
  swept.moving = {};
  control.report(stage, steps, steps);
  return {std::move(image), std::make_shared<const SweptBoundary>(std::move(swept))};
}

}  // namespace minkref::inline plane
