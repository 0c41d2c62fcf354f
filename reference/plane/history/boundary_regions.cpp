#include "reference/plane/history/boundary_regions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "reference/no_entry.hpp"
#include "reference/number/interval.hpp"

namespace minkref::inline plane {
namespace {

using EnclosedPoint = std::array<Interval, 2>;

EnclosedPoint near(const Point& p) { return {Interval(p.x), Interval(p.y)}; }

/// A value's sign from intervals, otherwise from the exact value.
template <class Exact>
int sign_of(const Interval& near, Exact&& exact) {
  if (const auto certain = certified_sign(near)) return *certain;
  return sign(exact());
}

/// Cycles as polygons at one scale: intervals first, exact numbers if these do not tell.
class CyclesAtScale {
 public:
  CyclesAtScale(const std::vector<Track>& tracks, const std::vector<BoundaryLink>& links,
                const Rational& scale)
      : tracks_(tracks), links_(links), scale_(scale) {
    const Interval s(scale);
    const auto at = [&](std::uint32_t track) {
      const auto& [a, b] = tracks[track];
      return EnclosedPoint{Interval(a.x) + s * Interval(b.x), Interval(a.y) + s * Interval(b.y)};
    };
    for (const BoundaryLink& link : links) {
      from_.push_back(at(link.from));
      to_.push_back(at(link.to));
    }
  }

  Point middle(std::uint32_t link) const {
    const Point a = from(link), b = to(link);
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
  }

  /// Whether a cycle winds around a point off the cycle.
  bool around(const BoundaryCycles& cycles, std::uint32_t cycle, const Point& m,
              const EnclosedPoint& near_m) const {
    bool inside = false;
    std::uint32_t k = cycles.cycles[cycle].first;
    do {
      const bool from_below =
          is_not_above(from_[k][1], near_m[1], [&] { return from(k).y <= m.y; });
      const bool to_below = is_not_above(to_[k][1], near_m[1], [&] { return to(k).y <= m.y; });
      if (from_below != to_below) {
        const auto &a = from_[k], &b = to_[k];
        const int side =
            sign_of((b[0] - a[0]) * (near_m[1] - a[1]) - (b[1] - a[1]) * (near_m[0] - a[0]), [&] {
              const Point p = from(k), q = to(k);
              return Rational((q.x - p.x) * (m.y - p.y) - (q.y - p.y) * (m.x - p.x));
            });
        if ((side > 0) == from_below) inside = !inside;
      }
      k = cycles.next[k];
    } while (k != cycles.cycles[cycle].first);
    return inside;
  }

  Rational magnitude(const BoundaryCycles& cycles, std::uint32_t cycle) const {
    Rational doubled = 0;
    std::uint32_t k = cycles.cycles[cycle].first;
    do {
      const Point p = from(k), q = to(k);
      doubled += p.x * q.y - p.y * q.x;
      k = cycles.next[k];
    } while (k != cycles.cycles[cycle].first);
    return abs(doubled);
  }

 private:
  template <class Exact>
  static bool is_not_above(const Interval& y, const Interval& than, Exact&& exact) {
    if (y.upper() <= than.lower()) return true;
    if (y.lower() > than.upper()) return false;
    return exact();
  }
  Point from(std::uint32_t link) const { return tracks_[links_[link].from].at(scale_); }
  Point to(std::uint32_t link) const { return tracks_[links_[link].to].at(scale_); }

  const std::vector<Track>& tracks_;
  const std::vector<BoundaryLink>& links_;
  const Rational& scale_;
  std::vector<EnclosedPoint> from_, to_;
};

/// The smallest of some cycles around a point; `no_entry` if none.
std::uint32_t smallest_around(const BoundaryCycles& cycles,
                              const std::vector<std::uint32_t>& enclosing, const Point& point,
                              const CyclesAtScale& at_scale) {
  const EnclosedPoint near_point = near(point);
  std::vector<std::uint32_t> found;
  for (const std::uint32_t e : enclosing) {
    if (at_scale.around(cycles, e, point, near_point)) found.push_back(e);
  }
  if (found.size() < 2) return found.empty() ? no_entry : found[0];
  const auto smallest =
      std::min_element(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
        return at_scale.magnitude(cycles, a) < at_scale.magnitude(cycles, b);
      });
  return *smallest;
}

/// Regions by their enclosing cycles (`left`: cycles that turn to the left); each other cycle
/// belongs to the smallest cycle around it, or to region `outermost`.
struct Regions {
  std::vector<std::uint32_t> of_cycle;
  std::uint32_t count = 0;
};

Regions regions_of(const BoundaryCycles& cycles, bool left, std::uint32_t first_name,
                   std::uint32_t outermost, bool only_one, const CyclesAtScale* at_scale) {
  Regions regions;
  regions.of_cycle.assign(cycles.cycles.size(), outermost);
  std::vector<std::uint32_t> enclosing;
  for (std::uint32_t c = 0; c < cycles.cycles.size(); ++c) {
    if (cycles.cycles[c].left != left) continue;
    regions.of_cycle[c] = first_name + regions.count++;
    enclosing.push_back(c);
  }
  for (std::uint32_t c = 0; c < cycles.cycles.size(); ++c) {
    if (cycles.cycles[c].left == left) continue;
    if (only_one) continue;
    const std::uint32_t best =
        smallest_around(cycles, enclosing, at_scale->middle(cycles.cycles[c].first), *at_scale);
    if (best != no_entry) regions.of_cycle[c] = regions.of_cycle[best];
  }
  return regions;
}

}  // namespace

BoundaryRegions boundary_regions(const std::vector<Track>& tracks, BoundaryState state,
                                 CycleFinder& finder, const Rational& scale) {
  BoundaryRegions result;
  result.place = finder.remove_duplicates(state.links);
  result.links = std::move(state.links);
  result.walks = finder.find(result.links, true);
  const BoundaryCycles& interior = result.walks;
  result.pinches = finder.pinches();
  const BoundaryCycles exterior = finder.find(result.links, false);
  const auto enclosing = std::count_if(interior.cycles.begin(), interior.cycles.end(),
                                       [](const auto& c) { return c.left; });
  std::optional<CyclesAtScale> at_scale;
  if (enclosing > 1) at_scale.emplace(tracks, result.links, scale);
  const bool one = enclosing <= 1;
  const CyclesAtScale* geometry = at_scale ? &*at_scale : nullptr;
  const Regions components = regions_of(interior, true, 0, 0, one, geometry);
  const Regions holes = regions_of(exterior, false, 1, 0, one, geometry);
  result.components = components.count;
  result.holes = holes.count;
  const std::size_t n = result.links.size();
  result.hole.resize(n);
  result.component.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    result.hole[i] = holes.of_cycle[exterior.cycle[i]];
    result.component[i] = components.of_cycle[interior.cycle[i]];
  }

  for (const BoundaryRing& ring : boundary_rings(result, finder)) {
    const std::size_t corners = ring.vertices.size();
    for (std::size_t i = 0; i < corners; ++i) {
      result.edges.emplace_back(ring.vertices[i], ring.vertices[(i + 1) % corners]);
    }
  }
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

std::uint32_t component_around(const std::vector<Track>& tracks, const BoundaryRegions& regions,
                               const Point& point, const Rational& scale) {
  if (regions.components == 1) return 0;
  const auto& cycles = regions.walks.cycles;
  std::vector<std::uint32_t> enclosing;
  for (std::uint32_t c = 0; c < cycles.size(); ++c) {
    if (cycles[c].left) enclosing.push_back(c);
  }
  const CyclesAtScale at_scale(tracks, regions.links, scale);
  const std::uint32_t best = smallest_around(regions.walks, enclosing, point, at_scale);
  if (best == no_entry) throw std::logic_error("a point of the interior is in no component");
  return regions.component[cycles[best].first];
}

std::vector<BoundaryRing> boundary_rings(const BoundaryRegions& regions,
                                         const CycleFinder& finder) {
  std::vector<BoundaryRing> rings;
  const auto& links = regions.links;
  const auto add = [&](const std::vector<std::uint32_t>& ring) {  // links in a row
    BoundaryRing result;
    int turns = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const BoundaryLink &in = links[ring[i]], &out = links[ring[(i + 1) % ring.size()]];
      if (!finder.same_direction(in.edge, out.edge)) {
        result.vertices.push_back(in.to);
        result.edges.push_back(out.edge);
      }
      turns += finder.half_turns(in.edge, out.edge);
    }
    result.is_hole = turns < 0;
    result.component = regions.component[ring.front()];
    result.hole = regions.hole[ring.front()];
    rings.push_back(std::move(result));
  };
  for (const auto& cycle : regions.walks.cycles) {
    std::vector<std::uint32_t> walk;
    if (regions.pinches.empty()) {
      std::uint32_t k = cycle.first;
      do {
        walk.push_back(k);
        k = regions.walks.next[k];
      } while (k != cycle.first);
      add(walk);
      continue;
    }
    // A walk that comes back to a point has closed a ring.
    std::unordered_map<std::uint32_t, std::size_t> place;  // of the link that leaves a point
    std::uint32_t k = cycle.first;
    do {
      place[links[k].from] = walk.size();
      walk.push_back(k);
      const auto back = place.find(links[k].to);
      if (back != place.end()) {
        const auto from = walk.begin() + static_cast<std::ptrdiff_t>(back->second);
        const std::vector<std::uint32_t> ring(from, walk.end());
        for (const std::uint32_t link : ring) place.erase(links[link].from);
        walk.erase(from, walk.end());
        add(ring);
      }
      k = regions.walks.next[k];
    } while (k != cycle.first);
  }
  return rings;
}

}  // namespace minkref::inline plane
