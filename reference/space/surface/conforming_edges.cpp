#include "reference/space/surface/conforming_edges.hpp"

#include <algorithm>

#include "reference/space/surface/hidden_edges.hpp"
#include "reference/space/surface/near_things.hpp"
#include "reference/space/surface/slits.hpp"

namespace minkref::inline space {
namespace {

using Borders = std::vector<std::vector<PointPair>>;

PointPair segment_of(const PointPair& edge) { return std::minmax(edge.first, edge.second); }

std::vector<PointPair> segments_of(const Borders& borders) {
  std::vector<PointPair> segments;
  for (const auto& border : borders) {
    for (const PointPair& edge : border) segments.push_back(segment_of(edge));
  }
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}

Borders borders_of(const LiftedRegions& regions) {
  Borders borders(regions.planes.size());
  for (const LiftedPolygon& polygon : regions.polygons) {
    for (const auto& ring : polygon.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        borders[polygon.region].emplace_back(ring[k], ring[(k + 1) % ring.size()]);
      }
    }
  }
  return borders;
}

/// Finds where segments have to be cut.
class MeetingSearch {
 public:
  MeetingSearch(const std::vector<SpaceVertex>& points, const std::vector<PointPair>& segments)
      : cuts(segments.size()), points_(points), segments_(segments) {}

  /// Point numbers, perhaps repeated; numbers beyond the given points refer to `fresh`.
  std::vector<std::vector<std::uint32_t>> cuts;
  std::vector<SpaceVertex> fresh;

  void run() {
    NearThings near(points_);
    for (const auto& [u, v] : segments_) near.add({u, v});
    near.pairs([&](std::uint32_t a, std::uint32_t b) { meet(a, b); });
  }

 private:
  void meet(std::uint32_t a, std::uint32_t b) {
    const auto [u, v] = segments_[a];
    const auto [p, q] = segments_[b];
    const BoundedVector d = points_[v].rounded - points_[u].rounded,
                        e = points_[q].rounded - points_[p].rounded,
                        w = points_[p].rounded - points_[u].rounded;
    const BoundedVector across = cross(d, e);
    const bool certainly_crossed = std::any_of(
        across.begin(), across.end(),
        [](const BoundedDouble& c) { return c.certain_sign() == 1 || c.certain_sign() == -1; });
    const bool joined = u == p || u == q || v == p || v == q;
    if (joined && certainly_crossed) return;
    const int apart = dot(across, w).certain_sign();
    if (apart == 1 || apart == -1) return;
    meet_exactly(a, b, joined);
  }

  void meet_exactly(std::uint32_t a, std::uint32_t b, bool joined) {
    const auto [u, v] = segments_[a];
    const auto [p, q] = segments_[b];
    const RationalVector d = points_[v].exact - points_[u].exact,
                         e = points_[q].exact - points_[p].exact,
                         w = points_[p].exact - points_[u].exact;
    const RationalVector across = cross(d, e);
    const auto at =
        std::find_if(across.begin(), across.end(), [](const Rational& c) { return !c.is_zero(); });
    if (at != across.end()) {
      if (joined || !dot(across, w).is_zero()) return;
      const auto k = static_cast<std::size_t>(at - across.begin());
      cross_at(a, b, cross(w, e)[k] / *at, cross(w, d)[k] / *at);
      return;
    }
    const RationalVector aside = cross(w, d);
    if (!std::all_of(aside.begin(), aside.end(), [](const Rational& c) { return c.is_zero(); })) {
      return;
    }
    // On one line, point numbers follow the points' order.
    for (const std::uint32_t end : {p, q}) {
      if (u < end && end < v) cuts[a].push_back(end);
    }
    for (const std::uint32_t end : {u, v}) {
      if (p < end && end < q) cuts[b].push_back(end);
    }
  }

  /// The lines cross at u + s (v - u) = p + t (q - p).
  void cross_at(std::uint32_t a, std::uint32_t b, const Rational& s, const Rational& t) {
    if (s < 0 || s > 1 || t < 0 || t > 1) return;
    const bool cuts_a = s > 0 && s < 1, cuts_b = t > 0 && t < 1;
    const auto [u, v] = segments_[a];
    const auto [p, q] = segments_[b];
    if (cuts_a && cuts_b) {
      const SpacePoint& from = points_[u].exact;
      const RationalVector d = points_[v].exact - from;
      const auto number = static_cast<std::uint32_t>(points_.size() + fresh.size());
      fresh.emplace_back(SpacePoint{from.x + s * d[0], from.y + s * d[1], from.z + s * d[2]});
      cuts[a].push_back(number);
      cuts[b].push_back(number);
    } else if (cuts_a) {
      cuts[a].push_back(t.is_zero() ? p : q);
    } else if (cuts_b) {
      cuts[b].push_back(s.is_zero() ? u : v);
    }
  }

  const std::vector<SpaceVertex>& points_;
  const std::vector<PointPair>& segments_;
};

/// Replaces the points by the old and the new points together; the numbers refer to the old points,
/// then the new.
SharedPoints add_points(std::vector<SpaceVertex>& points, const std::vector<SpaceVertex>& more) {
  std::vector<SpaceVertex> all = std::move(points);
  all.insert(all.end(), more.begin(), more.end());
  SharedPoints shared = shared_points(std::move(all));
  points = std::move(shared.points);
  return shared;
}

Borders cut_borders(const Borders& borders, const std::vector<PointPair>& segments,
                    const std::vector<std::vector<std::uint32_t>>& cuts) {
  Borders result;
  for (const auto& border : borders) {
    auto& pieces = result.emplace_back();
    for (const auto& edge : border) {
      const auto at = std::lower_bound(segments.begin(), segments.end(), segment_of(edge));
      std::vector<std::uint32_t> chain = cuts[static_cast<std::size_t>(at - segments.begin())];
      chain.push_back(edge.first);
      chain.push_back(edge.second);
      std::sort(chain.begin(), chain.end());
      chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
      if (edge.first > edge.second) std::reverse(chain.begin(), chain.end());
      for (std::size_t k = 1; k < chain.size(); ++k) pieces.emplace_back(chain[k - 1], chain[k]);
    }
  }
  return result;
}

}  // namespace

ConformingEdges conforming_edges(const PolyhedralSet& set) {
  const LiftedRegions regions(set);
  ConformingEdges result;
  result.points = regions.points;
  Borders borders = borders_of(regions);
  // The hidden edges stand in a list of their own, after the regions.
  auto& hidden = borders.emplace_back();
  std::vector<SpaceVertex> more;
  for (auto& [from, to] : hidden_edges(regions)) {
    const auto number = static_cast<std::uint32_t>(result.points.size() + more.size());
    more.push_back(std::move(from));
    more.push_back(std::move(to));
    hidden.emplace_back(number, number + 1);
  }
  const auto renumber = [](std::vector<PointPair>& edges, const SharedPoints& shared) {
    for (auto& [from, to] : edges) from = shared.number[from], to = shared.number[to];
  };
  if (!more.empty()) {
    const SharedPoints shared = add_points(result.points, more);
    for (auto& border : borders) renumber(border, shared);
  }
  std::vector<PointPair> segments = segments_of(borders);
  MeetingSearch search(result.points, segments);
  search.run();
  if (!search.fresh.empty()) {
    const SharedPoints shared = add_points(result.points, search.fresh);
    // The given points keep their order, and so do the segments.
    for (auto& border : borders) renumber(border, shared);
    renumber(segments, shared);
    for (auto& list : search.cuts) {
      for (std::uint32_t& point : list) point = shared.number[point];
    }
  }
  result.borders = cut_borders(borders, segments, search.cuts);
  result.segments = segments_of(result.borders);
  result.borders.pop_back();
  add_slits_and_tips(regions, result);
  return result;
}

}  // namespace minkref::inline space
