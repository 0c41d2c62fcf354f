#include "reference/plane/index/index_columns.hpp"

#include <algorithm>

#include "reference/error.hpp"

namespace minkref::inline plane {
namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  throw BadInput("damaged-index", std::string("the index contradicts itself: ") + what,
                 "build it again with `minkref index`");
}

template <class T, class Test>
void require_all(std::span<const T> items, const char* what, Test&& test) {
  require(std::all_of(items.begin(), items.end(), test), what);
}

/// Positions that never decrease and end at most at `size`.
template <class T, class Member>
void require_ascending(std::span<const T> items, Member member, std::size_t size,
                       const char* what) {
  std::size_t last = 0;
  for (const T& item : items) {
    require(member(item) >= last && member(item) <= size, what);
    last = member(item);
  }
}

void check_operand(std::span<const std::uint32_t> rings, const IntegerColumn& coordinates) {
  std::size_t vertices = 0;
  for (const std::uint32_t ring : rings) vertices += ring & 0x7fffffffU;
  require(coordinates.size() == 4 * vertices, "the rings of an operand");
  require(rings.empty() || (rings[0] >> 31) == 0, "the rings of an operand");
  for (std::size_t k = 0; k < coordinates.size(); k += 2) {
    require(coordinates[k + 1] > 0, "a denominator");
  }
}

void check_numbers(const IndexColumns& c) {
  require(c.window.size() == 4, "the window");
  const std::size_t events = c.events_in_doubles.size();
  require(c.events.size() == 2 * events, "the events");
  for (std::size_t k = 0; k < events; ++k) require(c.events[2 * k + 1] > 0, "the events");
  require(std::is_sorted(c.events_in_doubles.begin(), c.events_in_doubles.end()), "the events");
  require(c.tracks.size() == 5 * c.tracks_in_doubles.size(), "the tracks");
  for (std::size_t k = 0; k < c.tracks.size(); k += 5) {
    require(c.tracks[k + 4] > 0, "the tracks");
  }
  require(c.counts.track_bits <= 64 * std::uint64_t{c.tracks.words}, "the tracks");
  require(c.places.size() == 4 * (c.topology.size() + c.boundary.size()), "the places");
  for (std::size_t k = 0; k < c.places.size(); k += 2) {
    require(c.places[k + 1] > 0, "the places");
  }
}

void check_links(const IndexColumns& c) {
  const auto P = c.rings_of_P.size(), Q = c.rings_of_Q.size();
  require_all(c.edges, "the edges", [&](const IndexEdge& e) {
    const auto is_vertex = [](std::span<const std::uint32_t> rings, std::uint32_t ring,
                              std::uint32_t vertex) {
      return ring < rings.size() && vertex < (rings[ring] & 0x7fffffffU);
    };
    return e.is_t == 0 ? e.edge_ring < P && e.vertex_ring < Q &&
                             is_vertex(c.rings_of_P, e.edge_ring, e.edge) &&
                             is_vertex(c.rings_of_Q, e.vertex_ring, e.vertex)
                       : is_vertex(c.rings_of_Q, e.edge_ring, e.edge) &&
                             is_vertex(c.rings_of_P, e.vertex_ring, e.vertex);
  });
  require(c.directions.size() == c.edges.size(), "the directions");
  const auto tracks = c.tracks_in_doubles.size(), edges = c.edges.size(),
             intervals = c.bucket_of.size();
  require(intervals == c.events_in_doubles.size() + 1 && c.areas.size() == intervals,
          "the intervals");
  require_all(c.links, "the links", [&](const IndexLink& l) {
    return l.from < tracks && l.to < tracks && l.edge < edges && l.first <= l.last &&
           l.last < intervals;
  });
  require_all(c.pieces, "the pieces", [&](const IndexPiece& p) {
    return p.from < tracks && p.to < tracks && p.edge < edges && p.before < c.links.size() &&
           p.after < c.links.size();
  });
  require_all(c.merged, "the merged tracks",
              [&](const IndexMerged& m) { return m.track < tracks && m.stands_for < tracks; });
  require(c.at_events.size() == intervals, "the events");
  const auto ascending = [&](auto member, std::size_t size) {
    require_ascending(c.at_events, member, size, "the events");
  };
  ascending([](const IndexAtEvent& e) { return e.merged; }, c.merged.size());
  ascending([](const IndexAtEvent& e) { return e.pieces; }, c.pieces.size());
}

void check_buckets(const IndexColumns& c) {
  const auto intervals = c.bucket_of.size();
  require_all(c.bucket_of, "the buckets",
              [&](std::uint32_t bucket) { return bucket < c.buckets.size(); });
  require(c.ring_features.size() == c.ring_ends.size(), "the rings");
  require_all(c.entries, "the entries", [&](const IndexEntry& e) {
    return e.track < c.tracks_in_doubles.size() && e.edge < c.edges.size() && e.first <= e.last &&
           e.last < intervals;
  });
  std::uint32_t entry = 0, ring = 0;
  for (const IndexBucket& b : c.buckets) {
    require(b.first <= b.last && b.last < intervals && b.entry_begin == entry &&
                b.entry_begin <= b.entry_end && b.entry_end <= c.entries.size() &&
                b.ring_begin == ring && b.ring_begin <= b.ring_end &&
                b.ring_end <= c.ring_ends.size(),
            "the buckets");
    std::uint32_t last = entry;
    for (ring = b.ring_begin; ring < b.ring_end; ++ring) {
      require(c.ring_ends[ring] > last && c.ring_ends[ring] <= b.entry_end, "the rings");
      last = c.ring_ends[ring];
    }
    require(last == b.entry_end, "the rings");
    entry = b.entry_end;
  }
  require_all(c.ring_features, "the rings", [&](const IndexRing& r) {
    return r.hole < c.holes.size() && r.component < c.components.size();
  });
}

void check_timeline(const IndexColumns& c) {
  const auto events = c.events_in_doubles.size();
  for (const auto& features : {c.holes, c.components}) {
    require_all(features, "the features", [&](const IndexFeature& f) {
      return (f.born == no_event || f.born < events) && (f.died == no_event || f.died < events);
    });
  }
  require_all(c.topology, "the topology events", [&](const IndexTopologyEvent& e) {
    const auto features = e.kind == 0 ? c.holes.size() : c.components.size();
    if (e.event >= events || e.kind > 1 || e.change > 4 || e.before > e.after || e.after > e.end ||
        e.end > c.lists.size()) {
      return false;
    }
    const auto list = c.lists.subspan(e.before, e.end - e.before);
    return std::all_of(list.begin(), list.end(), [&](std::uint32_t f) { return f < features; });
  });
  require_all(c.boundary, "the boundary events", [&](const IndexBoundaryEvent& e) {
    if (e.event >= events || e.change > 3 || e.edges > e.end || e.end > c.lists.size())
      return false;
    const auto list = c.lists.subspan(e.edges, e.end - e.edges);
    return std::all_of(list.begin(), list.end(),
                       [&](std::uint32_t edge) { return edge < c.edges.size(); });
  });
  std::uint32_t last = 0;
  for (const IndexFeatureCount& f : c.feature_counts) {
    require(f.interval >= last && f.interval < c.bucket_of.size(), "the counts");
    last = f.interval;
  }
  require(c.feature_counts.empty() || c.feature_counts[0].interval == 0, "the counts");
}

}  // namespace

IndexColumns::IndexColumns(const IndexImage& image)
    : window(image.integers(Column::window)),
      rings_of_P(image.column<std::uint32_t>(Column::rings_of_P)),
      rings_of_Q(image.column<std::uint32_t>(Column::rings_of_Q)),
      coordinates_of_P(image.integers(Column::coordinates_of_P)),
      coordinates_of_Q(image.integers(Column::coordinates_of_Q)),
      edges(image.column<IndexEdge>(Column::edges)),
      directions(image.column<std::uint32_t>(Column::directions)),
      events(image.integers(Column::events)),
      events_in_doubles(image.column<double>(Column::events_in_doubles)),
      tracks(image.integers(Column::tracks)),
      tracks_in_doubles(image.column<IndexTrack>(Column::tracks_in_doubles)),
      links(image.column<IndexLink>(Column::links)),
      bucket_of(image.column<std::uint32_t>(Column::bucket_of)),
      buckets(image.column<IndexBucket>(Column::buckets)),
      entries(image.column<IndexEntry>(Column::entries)),
      ring_ends(image.column<std::uint32_t>(Column::ring_ends)),
      ring_features(image.column<IndexRing>(Column::ring_features)),
      areas(image.column<IndexArea>(Column::areas)),
      feature_counts(image.column<IndexFeatureCount>(Column::feature_counts)),
      merged(image.column<IndexMerged>(Column::merged)),
      pieces(image.column<IndexPiece>(Column::pieces)),
      at_events(image.column<IndexAtEvent>(Column::at_events)),
      holes(image.column<IndexFeature>(Column::holes)),
      components(image.column<IndexFeature>(Column::components)),
      topology(image.column<IndexTopologyEvent>(Column::topology)),
      boundary(image.column<IndexBoundaryEvent>(Column::boundary)),
      lists(image.column<std::uint32_t>(Column::lists)),
      places(image.integers(Column::places)) {
  const auto all_counts = image.column<IndexCounts>(Column::counts);
  require(all_counts.size() == 1, "the counts");
  counts = all_counts[0];
  check_operand(rings_of_P, coordinates_of_P);
  check_operand(rings_of_Q, coordinates_of_Q);
  check_numbers(*this);
  check_links(*this);
  check_buckets(*this);
  check_timeline(*this);
}

}  // namespace minkref::inline plane
