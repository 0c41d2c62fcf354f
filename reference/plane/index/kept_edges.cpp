#include "reference/plane/index/kept_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "reference/no_entry.hpp"
#include "reference/plane/index/patch_cells.hpp"
#include "reference/plane/lines.hpp"

namespace minkref::inline plane {
namespace {

using Area = MovingPairs::Box;
constexpr std::size_t most_boxes = 16;

void add_point(Area& box, const Point& p) { box.add(to_double(p.x), to_double(p.y), 0); }

bool may_overlap(const Area& a, const Area& b) {
  // Doubles that round to equal numbers may come from different ones: a hair of room.
  for (const std::size_t k : {0, 1}) {
    const double room = 0x1p-50 * (std::abs(a.low[k]) + std::abs(a.high[k]) + std::abs(b.low[k]) +
                                   std::abs(b.high[k]));
    if (a.low[k] > b.high[k] + room || b.low[k] > a.high[k] + room) return false;
  }
  return true;
}

/// All vertices of an operand, each with both neighbours.
struct OperandCorners {
  struct Corner {
    const Point *before, *at, *next;
  };
  std::vector<Corner> all;
  std::vector<std::uint32_t> first;  ///< of each ring
  Area box;

  explicit OperandCorners(const PolygonSet& set) {
    const auto add_ring = [&](const Ring& ring) {
      first.push_back(static_cast<std::uint32_t>(all.size()));
      for (std::size_t k = 0; k < ring.size(); ++k) {
        all.push_back(
            {&ring[(k + ring.size() - 1) % ring.size()], &ring[k], &ring[(k + 1) % ring.size()]});
        add_point(box, ring[k]);
      }
    };
    for (const Polygon& polygon : set.polygons) {
      add_ring(polygon.outer);
      for (const Ring& hole : polygon.holes) add_ring(hole);
    }
  }
  std::uint32_t number(VertexId id) const { return first[id.ring] + id.index; }
};

std::size_t hash_of(const OperandCorners::Corner& corner) {
  std::size_t hash = 0;
  for (const Rational* x : {&corner.at->x, &corner.at->y, &corner.next->x, &corner.next->y}) {
    hash = hash * 0x9e3779b97f4a7c15U + std::hash<double>{}(to_double(*x));
  }
  return hash;
}

/// An operand before and now: the old corner whose edge, and whose both edges, each new one has.
class Difference {
 public:
  Difference(const PolygonSet& before, const PolygonSet& now) : before_(before), now_(now) {
    edge_.resize(now_.all.size(), no_entry);
    if (before == now) {
      std::iota(edge_.begin(), edge_.end(), 0U);
      vertex_ = edge_;
      return;
    }
    is_known_ = has_area(before) && has_area(now);
    if (is_known_) compare();
  }

  bool is_known() const { return is_known_; }
  std::uint32_t edge(VertexId id) const { return edge_[now_.number(id)]; }
  std::uint32_t vertex(VertexId id) const { return vertex_[now_.number(id)]; }
  std::uint32_t old(VertexId id) const { return before_.number(id); }
  const std::vector<Area>& changed() const { return changed_; }
  Area around() const {
    Area box = before_.box;
    box.add(now_.box);
    return box;
  }

 private:
  void compare() {
    std::unordered_multimap<std::size_t, std::uint32_t> by_hash;
    for (std::uint32_t k = 0; k < before_.all.size(); ++k) {
      look_for_interrupt();
      by_hash.emplace(hash_of(before_.all[k]), k);
    }
    std::vector<char> stays(before_.all.size(), 0);
    vertex_.resize(now_.all.size(), no_entry);
    for (std::uint32_t k = 0; k < now_.all.size(); ++k) {
      look_for_interrupt();
      const auto& own = now_.all[k];
      const auto [first, last] = by_hash.equal_range(hash_of(own));
      for (auto found = first; found != last; ++found) {
        const auto& old = before_.all[found->second];
        if (*old.at != *own.at || *old.next != *own.next) continue;
        edge_[k] = found->second;
        stays[found->second] = 1;
        if (*old.before == *own.before) vertex_[k] = found->second;
      }
      if (vertex_[k] == no_entry) add_change(own, edge_[k] == no_entry);
    }
    for (std::uint32_t k = 0; k < before_.all.size(); ++k) {
      if (stays[k] == 0) add_change(before_.all[k], true);
    }
    unite();
  }

  /// A changed edge, or only a vertex with another edge before it.
  void add_change(const OperandCorners::Corner& corner, bool edge) {
    Area box;
    add_point(box, *corner.at);
    if (edge) add_point(box, *corner.next);
    changed_.push_back(box);
  }

  /// Unites boxes that overlap; to few boxes in the end.
  void unite() {
    for (bool again = true; again;) {
      again = false;
      std::vector<Area> kept;
      for (const Area& box : changed_) {
        look_for_interrupt();
        const auto other = std::find_if(kept.begin(), kept.end(),
                                        [&](const Area& k) { return may_overlap(k, box); });
        if (other == kept.end() && kept.size() < most_boxes) {
          kept.push_back(box);
          continue;
        }
        (other == kept.end() ? kept.back() : *other).add(box);
        again = true;
      }
      changed_ = std::move(kept);
    }
  }

  OperandCorners before_, now_;
  bool is_known_ = true;
  std::vector<std::uint32_t> edge_, vertex_;
  std::vector<Area> changed_;
};

/// A box for P plus a box for Q, through the window.
class SweptBox {
 public:
  SweptBox(const Area& of_P, const Area& of_Q, double from, double to) {
    for (const std::size_t corner : {0, 1, 2, 3}) {
      const auto at = [&](const Area& box, std::size_t axis) {
        return (corner >> axis & 1U) != 0 ? box.high[axis] : box.low[axis];
      };
      const RoundedEdge point{at(of_P, 0), at(of_P, 1), at(of_Q, 0), at(of_Q, 1), 0, 0, true};
      corners_[corner] = MovingPairs::way_of(point, from, to);
    }
    upright_ = along({1, 0});
  }

  bool may_meet(const RoundedEdge& edge, const MovingPairs::Way& way) const {
    if (!way.box().overlaps(upright_)) return false;
    const double length = std::hypot(edge.dx, edge.dy);
    if (!(length > 1e-100 && length < 1e100)) return true;
    const MovingPairs::Spot direction{edge.dx / length, edge.dy / length};
    return way.box_along(direction).overlaps(along(direction));
  }

 private:
  MovingPairs::MovingBox along(const MovingPairs::Spot& direction) const {
    MovingPairs::MovingBox box;
    for (const auto& corner : corners_) box.add(corner.box_along(direction));
    return box;
  }

  std::array<MovingPairs::Way, 4> corners_;
  MovingPairs::MovingBox upright_;
};

double extent(const Area& box) {
  return std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) * (1 + 0x1p-40);
}

/// A set's polygons and holes whose boxes come within `reach` of a box; some polygon at least.
PolygonSet part_near(const PolygonSet& set, Area box, double reach) {
  if (!has_area(set) || !(reach < 1e300)) return set;
  const double size = std::max(
      {std::abs(box.low[0]), std::abs(box.low[1]), std::abs(box.high[0]), std::abs(box.high[1])});
  const double room = reach + 0x1p-40 * (reach + size) + 1e-290;
  for (const std::size_t k : {0, 1}) box.low[k] -= room, box.high[k] += room;
  const auto is_near = [&](const Ring& ring) {
    Area own;
    for (const Point& p : ring) add_point(own, p);
    return may_overlap(own, box);
  };
  PolygonSet result;
  for (const Polygon& polygon : set.polygons) {
    look_for_interrupt();
    if (!is_near(polygon.outer)) continue;
    Polygon& part = result.polygons.emplace_back(Polygon{polygon.outer, {}});
    std::copy_if(polygon.holes.begin(), polygon.holes.end(), std::back_inserter(part.holes),
                 is_near);
  }
  if (result.empty()) result.polygons.push_back({set.polygons.front().outer, {}});
  return result;
}

}  // namespace

KeptEdges kept_edges(const Convolved& before, const Convolved& now,
                     const std::vector<RationalEdge>& moving, const ScaleWindow& window) {
  KeptEdges result;
  result.before.assign(now.edges.size(), no_entry);
  result.after.assign(before.edges.size(), no_entry);
  if (!window.from || before.edges.empty()) return result;
  const Difference P(before.P, now.P), Q(before.Q, now.Q);
  if (!P.is_known() || !Q.is_known()) return result;
  const double from = to_double(*window.from) * (1 - 0x1p-50),
               to = window.to ? to_double(*window.to) * (1 + 0x1p-50)
                              : std::numeric_limits<double>::infinity();
  std::vector<SweptBox> changed;
  for (const Area& box : P.changed()) changed.emplace_back(box, Q.around(), from, to);
  for (const Area& box : Q.changed()) changed.emplace_back(P.around(), box, from, to);
  using Kind = ConvolutionEdge::Kind;
  const auto key = [](std::uint32_t edge, std::uint32_t vertex) {
    return std::uint64_t{edge} << 32 | vertex;
  };
  std::array<std::unordered_map<std::uint64_t, std::uint32_t>, 2> old;
  for (std::uint32_t k = 0; k < before.edges.size(); ++k) {
    look_for_interrupt();
    const ConvolutionEdge& e = before.edges[k];
    const bool is_s = e.kind == Kind::S;
    old[is_s].emplace(
        is_s ? key(P.old(e.edge), Q.old(e.vertex)) : key(Q.old(e.edge), P.old(e.vertex)), k);
  }
  for (std::uint32_t k = 0; k < now.edges.size(); ++k) {
    look_for_interrupt();
    const ConvolutionEdge& e = now.edges[k];
    const bool is_s = e.kind == Kind::S;
    const std::uint32_t edge = (is_s ? P : Q).edge(e.edge),
                        vertex = (is_s ? Q : P).vertex(e.vertex);
    if (edge == no_entry || vertex == no_entry) continue;
    const auto found = old[is_s].find(key(edge, vertex));
    if (found == old[is_s].end()) continue;
    result.after[found->second] = k;
    const RoundedEdge near = rounded(moving[k]);
    const MovingPairs::Way way = MovingPairs::way_of(near, from, to);
    if (std::any_of(changed.begin(), changed.end(),
                    [&](const SweptBox& box) { return box.may_meet(near, way); })) {
      continue;
    }
    result.before[k] = found->second;
    ++result.count;
  }
  return result;
}

std::pair<PolygonSet, PolygonSet> parts_near(const PolygonSet& P, const PolygonSet& Q,
                                             const std::vector<RationalEdge>& moving,
                                             const std::vector<std::uint32_t>& which,
                                             const ScaleWindow& window) {
  // A point s p + q: of P only the part within (s p + q - Q) / s is asked about, which lies around
  // p, as far as Q is wide, over s; of Q only the part around q, as far as s P is wide.
  Area of_P, of_Q;
  for (const std::uint32_t k : which) {
    look_for_interrupt();
    const RoundedEdge e = rounded(moving[k]);
    of_P.add(e.px, e.py, 0);
    of_Q.add(e.qx, e.qy, 0);
    e.is_s ? of_P.add(e.px + e.dx, e.py + e.dy, 0) : of_Q.add(e.qx + e.dx, e.qy + e.dy, 0);
  }
  const Area whole_P = OperandCorners(P).box, whole_Q = OperandCorners(Q).box;
  const double low = window.from ? to_double(*window.from) : 0,
               high = window.to ? to_double(*window.to) : std::numeric_limits<double>::infinity();
  return {part_near(P, of_P, extent(whole_Q) / low), part_near(Q, of_Q, extent(whole_P) * high)};
}

}  // namespace minkref::inline plane
