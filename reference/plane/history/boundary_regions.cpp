#include "reference/plane/history/boundary_regions.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "reference/no_entry.hpp"

namespace minkref::inline plane {
namespace {

/// Cycles as polygons at one scale.
class CyclesAtScale {
 public:
  CyclesAtScale(const std::vector<Track>& tracks, const std::vector<BoundaryLink>& links,
                const Rational& scale) {
    for (const BoundaryLink& link : links) {
      from_.push_back(tracks[link.from].at(scale));
      to_.push_back(tracks[link.to].at(scale));
    }
  }

  Point middle(std::uint32_t link) const {
    return {(from_[link].x + to_[link].x) / 2, (from_[link].y + to_[link].y) / 2};
  }

  /// Whether a cycle winds around a point that is not on it.
  bool around(const BoundaryCycles& cycles, std::uint32_t cycle, const Point& m) const {
    bool inside = false;
    std::uint32_t k = cycles.cycles[cycle].first;
    do {
      const Point &a = from_[k], &b = to_[k];
      if ((a.y <= m.y) != (b.y <= m.y)) {
        const Rational side = (b.x - a.x) * (m.y - a.y) - (b.y - a.y) * (m.x - a.x);
        if ((sign(side) > 0) == (b.y > a.y)) inside = !inside;
      }
      k = cycles.next[k];
    } while (k != cycles.cycles[cycle].first);
    return inside;
  }

  Rational magnitude(const BoundaryCycles& cycles, std::uint32_t cycle) const {
    Rational doubled = 0;
    std::uint32_t k = cycles.cycles[cycle].first;
    do {
      doubled += from_[k].x * to_[k].y - from_[k].y * to_[k].x;
      k = cycles.next[k];
    } while (k != cycles.cycles[cycle].first);
    return abs(doubled);
  }

 private:
  std::vector<Point> from_, to_;
};

/// The smallest of some cycles around a point; `no_entry` where there is none.
std::uint32_t smallest_around(const BoundaryCycles& cycles,
                              const std::vector<std::uint32_t>& enclosing, const Point& point,
                              const CyclesAtScale& at_scale) {
  std::uint32_t best = no_entry;
  Rational size;
  for (const std::uint32_t e : enclosing) {
    if (!at_scale.around(cycles, e, point)) continue;
    const Rational own = at_scale.magnitude(cycles, e);
    if (best == no_entry || own < size) {
      best = e;
      size = own;
    }
  }
  return best;
}

/// Regions by their enclosing cycles (`left`: those that turn to the left); each other cycle
/// belongs to the smallest one around it, or to region `outermost`.
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
