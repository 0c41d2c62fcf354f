#include "reference/disc/diagram/boundary_walk.hpp"

#include <algorithm>
#include <map>

namespace minkref::inline disc {
namespace {

struct EdgePart {
  std::uint32_t edge, from, to;
};

class PartsOfEdges {
 public:
  explicit PartsOfEdges(const EdgeLookup& lookup) : curves_(lookup.curves()) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> touched;
    for (const auto& [edge, vertex] : lookup.touched()) touched[edge].push_back(vertex);
    for (std::uint32_t k = 0; k < curves_.edges.size(); ++k) {
      const OffsetEdge& edge = curves_.edges[k];
      std::uint32_t from = edge.start_feature;
      const auto add = [&](std::uint32_t to) {
        leaving_[from].push_back(static_cast<std::uint32_t>(parts_.size()));
        parts_.push_back({k, from, to});
        from = to;
      };
      const auto inside = touched.find(k);
      if (inside != touched.end()) {
        const auto& at = curves_.features;
        std::sort(inside->second.begin(), inside->second.end(), [&](auto a, auto b) {
          return dot(edge.along, from_to(at[a].centre, at[b].centre)) > 0;
        });
        std::for_each(inside->second.begin(), inside->second.end(), add);
      }
      add(edge.end_feature);
    }
  }

  const std::vector<EdgePart>& all() const { return parts_; }
  const OffsetEdge& edge(std::uint32_t part) const { return curves_.edges[parts_[part].edge]; }

  std::uint32_t next(std::uint32_t part) const {
    return next_outside(edge(part).along, leaving_.at(parts_[part].to),
                        [&](std::uint32_t k) -> const Direction& { return edge(k).along; });
  }

 private:
  const OffsetCurves& curves_;
  std::vector<EdgePart> parts_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaving_;  ///< by where they start
};

}  // namespace

BoundaryWalks boundary_walks(const EdgeLookup& lookup) {
  const PartsOfEdges parts(lookup);
  const auto& features = lookup.curves().features;
  BoundaryWalks result;
  std::vector<char> is_done(parts.all().size(), 0);
  for (std::uint32_t start = 0; start < is_done.size(); ++start) {
    if (is_done[start] != 0) continue;
    // About the point farthest left of a component more than half a turn is free.
    const Point* least = nullptr;
    BoundaryWalk walk{static_cast<std::uint32_t>(result.sides.size()), 0, false};
    for (std::uint32_t part = start; is_done[part] == 0;) {
      is_done[part] = 1;
      const EdgePart& own = parts.all()[part];
      const std::uint32_t next = parts.next(part);
      const OffsetEdge &in = parts.edge(part), &out = parts.edge(next);
      const Rational turn = cross(in.along, out.along);
      const bool is_convex = turn > 0 || (turn == 0 && dot(in.along, out.along) < 0);
      result.sides.push_back({in.feature, own.edge, own.edge, own.from, own.to, false, turn < 0});
      if (is_convex) {
        result.sides.push_back(
            {own.to, own.edge, parts.all()[next].edge, own.to, own.to, true, false});
      }
      const Point& at = features[own.to].centre;
      if (least == nullptr || at.x < least->x || (at.x == least->x && at.y < least->y)) {
        least = &at;
        walk.is_outer = is_convex;
      } else if (at == *least) {
        walk.is_outer |= is_convex;
      }
      part = next;
    }
    walk.last = static_cast<std::uint32_t>(result.sides.size());
    result.walks.push_back(walk);
  }
  return result;
}

}  // namespace minkref::inline disc
