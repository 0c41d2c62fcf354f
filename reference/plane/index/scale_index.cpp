#include "reference/plane/index/scale_index.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/history/boundary_regions.hpp"
#include "reference/plane/index/area_of_intervals.hpp"
#include "reference/plane/index/index_build.hpp"
#include "reference/plane/index/track_numbers.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {
namespace {

Rational number(const IntegerColumn& column, std::size_t k) { return {column[k], column[k + 1]}; }
Point point(const IntegerColumn& column, std::size_t k) {
  return {number(column, k), number(column, k + 2)};
}

PolygonSet operand_of(std::span<const std::uint32_t> rings, const IntegerColumn& coordinates) {
  PolygonSet set;
  std::size_t next = 0;
  for (const std::uint32_t size : rings) {
    const bool is_hole = (size >> 31) != 0;
    if (!is_hole) set.polygons.emplace_back();
    Polygon& polygon = set.polygons.back();
    Ring& ring = is_hole ? polygon.holes.emplace_back() : polygon.outer;
    for (std::uint32_t k = 0; k < (size & 0x7fffffffU); ++k, next += 4) {
      ring.push_back(point(coordinates, next));
    }
  }
  return set;
}

std::optional<Rational> bound(const IntegerColumn& window, std::size_t k) {
  if (window[k + 1] == 0) return std::nullopt;
  return number(window, k);
}

RingFeatures features_of(const IndexRing& ring) {
  return {ring.is_hole != 0, ring.hole, ring.component};
}

/// Sums neighbours, then the sums, and so on: each addition has numbers of about equal length.
Rational tree_sum(std::vector<Rational> values) {
  if (values.empty()) return 0;
  while (values.size() > 1) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < values.size(); k += 2) {
      values[kept++] = k + 1 < values.size() ? Rational(values[k] + values[k + 1]) : values[k];
    }
    values.resize(kept);
  }
  return values[0];
}

BadInput contradicts_itself(const std::string& what) {
  return {"damaged-index", "the index contradicts itself: " + what,
          "build it again with `minkref index`"};
}

/// Validates the operands of an opened index, for algorithms that rely on valid operands.
void require_valid(std::initializer_list<std::reference_wrapper<const PolygonSet>> operands) {
  for (const PolygonSet& operand : operands) {
    try {
      validate(operand);
    } catch (const BadInput& fault) {
      throw contradicts_itself("an operand is none: " + fault.problem());
    }
  }
}

}  // namespace

void refuse_outside(const ScaleWindow& window, const Rational& scale) {
  if (scale <= 0 || (window.from && scale < *window.from) || (window.to && scale > *window.to)) {
    throw BadInput("outside-window", "the index does not hold the scale " + to_string(scale),
                   "ask for a scale of its window, or build an index of a larger one");
  }
}

ScaleIndex::ScaleIndex(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       const BuildOptions& options)
    : ScaleIndex(built_index(P, Q, window, options)) {}

ScaleIndex::ScaleIndex(BuiltIndex built)
    : ScaleIndex(std::move(built.image), std::move(built.swept)) {}

ScaleIndex ScaleIndex::updated(const PolygonSet& P, const PolygonSet& Q,
                               const BuildOptions& options) const {
  if (!swept_) return {P, Q, window_, options};
  const PolygonSet old_P = this->P(), old_Q = this->Q();
  const std::vector<ConvolutionEdge> old_edges = edges();
  const SweptBefore before{{old_P, old_Q, old_edges}, *swept_};
  return ScaleIndex(built_index(P, Q, window_, options, &before));
}

ScaleIndex::Reuse ScaleIndex::reuse() const {
  if (!swept_) return {};
  return {swept_->edges_kept, columns_.edges.size() - swept_->edges_kept, swept_->pairs_looked_at,
          swept_->faces_tested};
}

ScaleIndex ScaleIndex::open(const std::string& path) {
  try {
    return ScaleIndex(IndexImage::read(path));
  } catch (const BadInput& refusal) {
    throw refusal.from(path);
  }
}

ScaleIndex::ScaleIndex(IndexImage image, std::shared_ptr<const SweptBoundary> swept)
    : image_(std::move(image)),
      columns_(image_),
      window_{bound(columns_.window, 0), bound(columns_.window, 2)},
      swept_(std::move(swept)) {
  for (const IndexTrack& t : columns_.tracks_in_doubles) {
    for (const double c : {t.x0, t.y0, t.x1, t.y1}) largest_ = std::max(largest_, std::fabs(c));
  }
}

PolygonSet ScaleIndex::P() const {
  return operand_of(columns_.rings_of_P, columns_.coordinates_of_P);
}
PolygonSet ScaleIndex::Q() const {
  return operand_of(columns_.rings_of_Q, columns_.coordinates_of_Q);
}

std::vector<ConvolutionEdge> ScaleIndex::edges() const {
  std::vector<ConvolutionEdge> result;
  for (const IndexEdge& e : columns_.edges) {
    result.push_back({e.is_t == 0 ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T,
                      1,
                      {e.edge_ring, e.edge},
                      {e.vertex_ring, e.vertex}});
  }
  return result;
}

std::pair<std::uint32_t, std::uint32_t> ScaleIndex::events_within() const {
  std::uint32_t first = 0, last = static_cast<std::uint32_t>(events());
  while (window_.from && first < last && event(first) < *window_.from) ++first;
  while (window_.to && last > first && event(last - 1) > *window_.to) --last;
  return {first, last};
}

Rational ScaleIndex::event(std::uint32_t k) const { return number(columns_.events, 2 * k); }

Track ScaleIndex::track(std::uint32_t k) const {
  const IntegerColumn& t = columns_.tracks;
  const std::size_t at = std::size_t{k} * 5;
  const Integer c = t[at + 4];
  return {{Rational(t[at], c), Rational(t[at + 1], c)},
          {Rational(t[at + 2], c), Rational(t[at + 3], c)}};
}

ScaleIndex::Place ScaleIndex::place(const Rational& scale) const {
  const FloatEnvironment standard;
  refuse_outside(window_, scale);
  const std::span<const double> near_events = columns_.events_in_doubles;
  const double near = to_double(scale), doubt = 0x1p-50 * near;
  auto at = static_cast<std::size_t>(
      std::lower_bound(near_events.begin(), near_events.end(), near - doubt) - near_events.begin());
  for (; at < near_events.size() && near_events[at] <= near + doubt; ++at) {
    const Rational exact = event(static_cast<std::uint32_t>(at));
    if (exact >= scale) return {static_cast<std::uint32_t>(at), exact == scale};
  }
  return {static_cast<std::uint32_t>(at), false};
}

bool ScaleIndex::is_plain(const Place& at) const {
  return !at.at_event || columns_.at_events[at.interval].is_plain != 0;
}

void ScaleIndex::collect(const Place& at, TrackRings& rings) const {
  try {
    if (is_plain(at)) {
      collect_from_bucket(at, rings);
    } else {
      collect_touching(at.interval, rings);
    }
  } catch (const std::logic_error& contradiction) {
    if (swept_) throw;
    throw contradicts_itself(contradiction.what());
  }
}

void ScaleIndex::collect_from_bucket(const Place& at, TrackRings& rings) const {
  const IndexBucket& bucket = columns_.buckets[columns_.bucket_of[at.interval]];
  const std::size_t most = bucket.entry_end - bucket.entry_begin + 1;
  rings.tracks.resize(most);
  rings.edges.resize(most);
  const std::size_t count =
      each_ring(at.interval, rings, [&](const IndexEntry& entry, std::size_t k) {
        rings.tracks[k] = entry.track;
        rings.edges[k] = entry.edge;
      });
  rings.tracks.resize(count);
  rings.edges.resize(count);
  if (at.at_event) drop_what_vanishes(at.interval, rings);
}

template <class Take>
std::size_t ScaleIndex::each_ring(std::uint32_t interval, RingShape& shape, Take&& take) const {
  const IndexBucket& bucket = columns_.buckets[columns_.bucket_of[interval]];
  const IndexEntry* const entries = columns_.entries.data();
  shape.ring_ends.clear();
  shape.rings.clear();
  std::size_t count = 0;
  std::uint32_t k = bucket.entry_begin;
  for (std::uint32_t r = bucket.ring_begin; r < bucket.ring_end; ++r) {
    const std::size_t before = count;
    for (const std::uint32_t end = columns_.ring_ends[r]; k < end; ++k) {
      const IndexEntry& entry = entries[k];
      take(entry, count);  // absent entries are overwritten
      count += interval - entry.first <= entry.last - entry.first ? 1 : 0;
    }
    if (count == before) continue;
    shape.ring_ends.push_back(static_cast<std::uint32_t>(count));
    shape.rings.push_back(features_of(columns_.ring_features[r]));
  }
  return count;
}

std::uint32_t ScaleIndex::standing_for(std::uint32_t event, std::uint32_t track) const {
  const std::uint32_t begin = columns_.at_events[event].merged,
                      end = columns_.at_events[event + 1].merged;
  const auto merged = columns_.merged.subspan(begin, end - begin);
  const auto found =
      std::lower_bound(merged.begin(), merged.end(), track,
                       [](const IndexMerged& m, std::uint32_t t) { return m.track < t; });
  return found != merged.end() && found->track == track ? found->stands_for : track;
}

void ScaleIndex::drop_what_vanishes(std::uint32_t event, TrackRings& rings) const {
  std::size_t kept = 0, first = 0;
  std::vector<std::uint32_t> tracks, edges;
  for (std::uint32_t& ring_end : rings.ring_ends) {
    tracks.clear();
    edges.clear();
    for (std::size_t k = first; k < ring_end; ++k) {
      const std::size_t next = k + 1 == ring_end ? first : k + 1;
      if (standing_for(event, rings.tracks[k]) == standing_for(event, rings.tracks[next])) continue;
      tracks.push_back(rings.tracks[k]);
      edges.push_back(rings.edges[k]);
    }
    const std::size_t begin = kept;
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      const std::size_t before = k == 0 ? tracks.size() - 1 : k - 1;
      if (columns_.directions[edges[before]] == columns_.directions[edges[k]]) continue;
      rings.tracks[kept] = tracks[k];
      rings.edges[kept++] = edges[k];
    }
    first = ring_end;
    ring_end = static_cast<std::uint32_t>(kept);
    if (kept == begin) throw std::logic_error("a ring vanishes at an event that keeps the rings");
  }
  rings.tracks.resize(kept);
  rings.edges.resize(kept);
}

Vector2<Rational> ScaleIndex::direction(const IndexEdge& edge) const {
  const bool is_s = edge.is_t == 0;
  const auto rings = is_s ? columns_.rings_of_P : columns_.rings_of_Q;
  const IntegerColumn& coordinates = is_s ? columns_.coordinates_of_P : columns_.coordinates_of_Q;
  std::size_t first = 0;
  for (std::uint32_t r = 0; r < edge.edge_ring; ++r) first += rings[r] & 0x7fffffffU;
  const std::uint32_t size = rings[edge.edge_ring] & 0x7fffffffU;
  const Point from = point(coordinates, 4 * (first + edge.edge)),
              to = point(coordinates, 4 * (first + (edge.edge + 1) % size));
  return {Rational(to.x - from.x), Rational(to.y - from.y)};
}

void ScaleIndex::collect_touching(std::uint32_t event, TrackRings& rings) const {
  const IndexAtEvent &own = columns_.at_events[event], &next = columns_.at_events[event + 1];
  BoundaryState state;
  for (const IndexLink& link : columns_.links) {
    if (link.first > event || link.last <= event) continue;
    state.links.push_back(
        {standing_for(event, link.from), standing_for(event, link.to), link.edge, 0, 0});
  }
  for (const IndexPiece& p : columns_.pieces.subspan(own.pieces, next.pieces - own.pieces)) {
    state.links.push_back({p.from, p.to, p.edge, 0, 0});
  }
  // Tracks and edges that occur, renumbered.
  std::vector<std::uint32_t> used, lines;
  for (const BoundaryLink& link : state.links) {
    used.insert(used.end(), {link.from, link.to});
    lines.push_back(link.edge);
  }
  const auto number_all = [](std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  number_all(used);
  number_all(lines);
  const auto renumber = [](const std::vector<std::uint32_t>& list, std::uint32_t& name) {
    name =
        static_cast<std::uint32_t>(std::lower_bound(list.begin(), list.end(), name) - list.begin());
  };
  for (BoundaryLink& link : state.links) {
    renumber(used, link.from);
    renumber(used, link.to);
    renumber(lines, link.edge);
  }
  std::vector<Track> tracks;
  for (const std::uint32_t number : used) tracks.push_back(track(number));
  std::vector<RationalEdge> moving;  // only directions matter
  for (const std::uint32_t edge : lines) {
    moving.push_back({ConvolutionEdge::Kind::S, {}, {}, direction(columns_.edges[edge])});
  }
  CycleFinder finder(moving);
  const BoundaryRegions regions =
      boundary_regions(tracks, std::move(state), finder, this->event(event));
  rings.tracks.clear();
  rings.edges.clear();
  rings.ring_ends.clear();
  rings.rings.clear();
  for (const BoundaryRing& ring : boundary_rings(regions, finder)) {
    for (const std::uint32_t vertex : ring.vertices) rings.tracks.push_back(used[vertex]);
    for (const std::uint32_t edge : ring.edges) rings.edges.push_back(lines[edge]);
    rings.ring_ends.push_back(static_cast<std::uint32_t>(rings.tracks.size()));
    rings.rings.push_back({ring.is_hole, ring.hole, ring.component});
  }
}

void ScaleIndex::rings(const Rational& scale, TrackRings& rings) const {
  const FloatEnvironment standard;
  collect(place(scale), rings);
}

void ScaleIndex::rings_of_interval(std::uint32_t interval, TrackRings& rings) const {
  require_interval(interval);
  collect({interval, false}, rings);
}

void ScaleIndex::require_interval(std::uint32_t interval) const {
  if (interval <= events()) return;
  throw BadInput("no-interval", "the index has no interval " + std::to_string(interval),
                 "ask for one of 0 to " + std::to_string(events()));
}

void ScaleIndex::rings(const Rational& scale, RoundedRings& rings) const {
  const FloatEnvironment standard;
  const Place at = place(scale);
  const double s = to_double(scale);
  const IndexTrack* const tracks = columns_.tracks_in_doubles.data();
  // Coefficients and the scale are rounded once each, a product and a sum once more.
  rings.error = (0x1p-50 * largest_ + 0x1p-1020) * (1 + s);
  if (at.at_event) {
    TrackRings exact;
    collect(at, exact);
    static_cast<RingShape&>(rings) = std::move(static_cast<RingShape&>(exact));
    rings.x.clear();
    rings.y.clear();
    for (const std::uint32_t track : exact.tracks) {
      rings.x.push_back(tracks[track].x0 + s * tracks[track].x1);
      rings.y.push_back(tracks[track].y0 + s * tracks[track].y1);
    }
    return;
  }
  const IndexBucket& bucket = columns_.buckets[columns_.bucket_of[at.interval]];
  const std::size_t most = bucket.entry_end - bucket.entry_begin + 1;
  rings.x.resize(most);
  rings.y.resize(most);
  rings.edges.resize(most);
  double *const x = rings.x.data(), *const y = rings.y.data();
  std::uint32_t* const edges = rings.edges.data();
  const std::size_t count =
      each_ring(at.interval, rings, [&](const IndexEntry& entry, std::size_t k) {
        const IndexTrack& track = tracks[entry.track];
        x[k] = track.x0 + s * track.x1;
        y[k] = track.y0 + s * track.y1;
        edges[k] = entry.edge;
      });
  rings.x.resize(count);
  rings.y.resize(count);
  rings.edges.resize(count);
}

void ScaleIndex::rings(const Rational& scale, HomogeneousRings& rings) const {
  const FloatEnvironment standard;
  TrackRings tracks;
  static_cast<RingShape&>(tracks) = std::move(static_cast<RingShape&>(rings));
  collect(place(scale), tracks);
  static_cast<RingShape&>(rings) = std::move(static_cast<RingShape&>(tracks));
  homogeneous_numbers(columns_.tracks, columns_.counts.track_bits, tracks.tracks, scale, rings);
}

void ScaleIndex::rings(const Rational& scale, RationalRings& rings) const {
  const FloatEnvironment standard;
  HomogeneousRings exact;
  static_cast<RingShape&>(exact) = std::move(static_cast<RingShape&>(rings));
  this->rings(scale, exact);
  reduced_numbers(exact, rings);
  static_cast<RingShape&>(rings) = std::move(static_cast<RingShape&>(exact));
}

Sum ScaleIndex::sum(const Rational& scale, Passages passages) const {
  const FloatEnvironment standard;
  RationalRings rings;
  this->rings(scale, rings);
  const IntegerColumn numbers = rings.column();
  const auto less = [](const Point& p, const Point& q) {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  };
  const auto ring_less = [&](const Ring& a, const Ring& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
  };
  std::vector<std::pair<std::uint32_t, Polygon>> polygons;  // by component
  const auto polygon_of = [&](std::uint32_t component) -> Polygon& {
    for (auto& [name, polygon] : polygons) {
      if (name == component) return polygon;
    }
    return polygons.emplace_back(component, Polygon{}).second;
  };
  std::size_t first = 0;
  for (std::size_t r = 0; r < rings.ring_ends.size(); ++r) {
    Ring ring;
    for (std::size_t k = first; k < rings.ring_ends[r]; ++k) {
      ring.push_back({numbers.reduced(4 * k), numbers.reduced(4 * k + 2)});
    }
    first = rings.ring_ends[r];
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
    Polygon& polygon = polygon_of(rings.rings[r].component);
    if (rings.rings[r].is_hole) {
      polygon.holes.push_back(std::move(ring));
    } else {
      polygon.outer = std::move(ring);
    }
  }
  Sum result;
  for (auto& [name, polygon] : polygons) {
    std::sort(polygon.holes.begin(), polygon.holes.end(), ring_less);
    result.region.polygons.push_back(std::move(polygon));
  }
  std::sort(result.region.polygons.begin(), result.region.polygons.end(),
            [&](const Polygon& a, const Polygon& b) { return ring_less(a.outer, b.outer); });
  const Features counted = features(scale);
  result.components = counted.components;
  result.holes = counted.holes;
  result.statistics.s_edges = columns_.counts.s_edges;
  result.statistics.t_edges = columns_.counts.t_edges;
  if (passages == Passages::find) {
    result.tight_passages.emplace();
    if (!result.region.empty()) {
      const PolygonSet P = this->P(), Q = this->Q();
      if (!swept_) require_valid({P, Q});
      result.tight_passages = tight_passages(P, Q, scale);
    }
  }
  return result;
}

ScaleIndex::Features ScaleIndex::features(const Rational& scale) const {
  const FloatEnvironment standard;
  const Place at = place(scale);
  const auto rows = columns_.feature_counts;
  const auto next = std::partition_point(
      rows.begin(), rows.end(),
      [&](const IndexFeatureCount& row) { return row.interval <= at.interval; });
  if (at.at_event && next != rows.end() && next->interval == at.interval + 1) {
    return {next->components_at, next->holes_at};
  }
  if (next == rows.begin()) return {};
  return {std::prev(next)->components, std::prev(next)->holes};
}

ScaleIndex::RoundedArea ScaleIndex::area(const Rational& scale) const {
  const FloatEnvironment standard;
  const IndexArea& a = columns_.areas[place(scale).interval];
  const double s = to_double(scale);
  return {a.a0 + s * (a.a1 + s * a.a2),
          0x1p-49 * (std::fabs(a.a0) + s * (std::fabs(a.a1) + s * std::fabs(a.a2))) +
              (a.error + 0x1p-1020) * (1 + s * (1 + s))};
}

std::array<Rational, 3> ScaleIndex::area_polynomial(std::uint32_t interval) const {
  require_interval(interval);
  std::array<std::vector<Rational>, 3> parts;
  for (const IndexLink& link : columns_.links) {
    if (link.first > interval || link.last < interval) continue;
    const auto own = area_below(track(link.from), track(link.to));
    for (std::size_t i = 0; i < 3; ++i) parts[i].push_back(own[i]);
  }
  return {tree_sum(std::move(parts[0])), tree_sum(std::move(parts[1])),
          tree_sum(std::move(parts[2]))};
}

TopologyTimeline ScaleIndex::timeline() const {
  const FloatEnvironment standard;
  TopologyTimeline result;
  const auto features = [](std::span<const IndexFeature> all) {
    std::vector<Feature> list;
    const auto group = [](std::uint32_t event) {
      return event == no_event ? std::nullopt : std::optional(event);
    };
    for (const IndexFeature& f : all) list.push_back({group(f.born), group(f.died)});
    return list;
  };
  const auto list = [&](std::uint32_t begin, std::uint32_t end) {
    const auto part = columns_.lists.subspan(begin, end - begin);
    return std::vector<std::uint32_t>(part.begin(), part.end());
  };
  result.holes = features(columns_.holes);
  result.components = features(columns_.components);
  std::size_t place = 0;
  for (const IndexTopologyEvent& e : columns_.topology) {
    result.topology.push_back({e.event, static_cast<FeatureKind>(e.kind),
                               static_cast<TopologyEvent::Change>(e.change),
                               list(e.before, e.after), list(e.after, e.end), e.parts,
                               point(columns_.places, 4 * place++)});
  }
  for (const IndexBoundaryEvent& e : columns_.boundary) {
    result.boundary.push_back({e.event, static_cast<BoundaryEvent::Change>(e.change),
                               list(e.edges, e.end), point(columns_.places, 4 * place++)});
  }
  for (const IndexFeatureCount& c : columns_.feature_counts) {
    result.counts.push_back({c.interval, c.holes, c.components, 0, c.holes_at, c.components_at});
  }
  return result;
}

}  // namespace minkref::inline plane
