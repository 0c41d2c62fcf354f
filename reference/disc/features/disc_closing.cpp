#include "reference/disc/features/disc_closing.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "reference/disc/features/rest_measures.hpp"
#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/erosion/outside.hpp"

namespace minkref::inline disc {
namespace {

constexpr std::uint32_t unknown = DiagramGraph::none;

/// Links free arcs and visible parts.
class ClosingRings {
 public:
  ClosingRings(const RegionOutlines& outlines, const RestMaterial& rest)
      : parts_(outlines.regions().parts),
        halves_(outlines.index().graph().halves),
        rest_(rest),
        corners_(outlines.corners()),
        arc_at_foot_(corners_.size(), unknown),
        behind_crossing_(rest.arcs.size(), unknown),
        corner_of_half_(halves_.size(), unknown),
        visible_to_(halves_.size(), unknown) {
    for (std::uint32_t k = 0; k < corners_.size(); ++k) {
      corner_of_half_[corners_[k].half] = corner_of_half_[halves_[corners_[k].half].twin] = k;
    }
    for (std::uint32_t k = 0; k < parts_.visible.size(); ++k) {
      visible_to_[parts_.visible[k].to] = k;
    }
    for (std::uint32_t k = 0; k < rest.arcs.size(); ++k) {
      if (rest.arcs[k].from.is_foot()) arc_at_foot_[rest.arcs[k].corner] = k;
    }
    for (const FeatureRest& feature : rest.features) {
      for (const RestRing& ring : feature.rings) link(ring);
    }
  }

  std::vector<ClosingRing> find() {
    std::vector<ClosingRing> rings;
    std::vector<char> arc_done(rest_.arcs.size(), 0), part_done(parts_.visible.size(), 0);
    const auto walk_from = [&](ClosingPiece piece) {
      ClosingRing ring{{}, unknown};
      for (;;) {
        char& done = (piece.is_arc ? arc_done : part_done)[piece.number];
        if (done != 0) break;
        done = 1;
        ring.pieces.push_back(piece);
        piece = next(piece);
      }
      if (!ring.pieces.empty()) rings.push_back(std::move(ring));
    };
    for (std::uint32_t k = 0; k < arc_done.size(); ++k) walk_from({true, k});
    for (std::uint32_t k = 0; k < part_done.size(); ++k) walk_from({false, k});
    for (const PartRing& ring : parts_.visible_rings) {
      if (ring.parts.empty()) rings.push_back({{}, ring.walk});
    }
    return rings;
  }

 private:
  void link(const RestRing& ring) {
    for (std::size_t k = 0; k < ring.pieces.size(); ++k) {
      const RestPiece &own = ring.pieces[k], &after = ring.pieces[(k + 1) % ring.pieces.size()];
      if (own.is_arc && after.is_arc) behind_crossing_[own.number] = after.number;
    }
  }

  ClosingPiece next(const ClosingPiece& piece) const {
    if (piece.is_arc) {
      const FreeArc& arc = rest_.arcs[piece.number];
      if (!arc.to.is_foot()) return {true, behind_crossing_[piece.number]};
      return {false, visible_to_[halves_[corners_[arc.corner].half].twin]};
    }
    // At the part's start, a corner's foot; without an arc there two discs meet at a vertex of P,
    // and the part before goes on.
    const std::uint32_t corner = corner_of_half_[parts_.visible[piece.number].from];
    if (arc_at_foot_[corner] != unknown) return {true, arc_at_foot_[corner]};
    return {false, visible_to_[parts_.hidden[corner].from]};
  }

  const BoundaryParts& parts_;
  const std::vector<DiagramHalf>& halves_;
  const RestMaterial& rest_;
  const std::vector<CornerBridge>& corners_;
  std::vector<std::uint32_t> arc_at_foot_;      ///< by corner: the free arc from its first foot
  std::vector<std::uint32_t> behind_crossing_;  ///< by arc
  std::vector<std::uint32_t> corner_of_half_;
  std::vector<std::uint32_t> visible_to_;  ///< by half: the visible part that ends there
};

/// Counts the complement's components: connected places with d >= ρ, joined where their discs
/// overlap.
std::size_t complement_count(const RegionOutlines& outlines, const RestMaterial& rest) {
  const DiscIndex& index = outlines.index();
  const DiagramGraph& graph = index.graph();
  const std::uint32_t level = outlines.regions().radius.level;
  const std::size_t nodes = graph.events + graph.gaps + graph.reflex_vertices;
  const auto outside = static_cast<std::uint32_t>(nodes);
  DisjointSets sets(nodes + 1);
  std::vector<char> is_there(nodes + 1, 0);
  is_there[outside] = 1;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    is_there[node] = index.radius_number(node) > level ? 1 : 0;
    if (graph.is_infinite(node)) sets.join(node, outside);
  }
  for (std::uint32_t k = 0; k < graph.halves.size(); ++k) {
    if (index.low(k) > level) sets.join(graph.halves[k].from, graph.halves[k].to);
  }
  const auto upper = [&](std::uint32_t corner) {
    return graph.halves[outlines.corners()[corner].half].to;
  };
  for (const auto& [a, b] : rest.overlaps) sets.join(upper(a), upper(b));
  std::size_t count = 0;
  for (std::uint32_t node = 0; node <= nodes; ++node) {
    if (is_there[node] != 0 && sets.root(node) == node) ++count;
  }
  return count;
}

/// Counts the interior's components: polygons and parts of the rest, joined along hidden edges.
class Interior {
 public:
  Interior(const RegionOutlines& outlines, const RestMaterial& rest)
      : outlines_(outlines), rest_(rest), index_(outlines.index()), sets_(count_all()) {}

  std::size_t count() {
    for (std::uint32_t k = 0; k < rest_.features.size(); ++k) add(rest_.features[k]);
    for (const Island& island : open_) settle(island);
    return sets_.count();
  }

 private:
  std::size_t count_all() {
    for (const OffsetEdge& edge : index_.diagram().curves.edges) {
      polygons_ = std::max(polygons_, edge.polygon + 1);
    }
    std::size_t all = polygons_;
    for (const FeatureRest& feature : rest_.features) all += feature.components;
    next_ = polygons_;
    return all;
  }

  void add(const FeatureRest& feature) {
    if (feature.components == 0) return;
    const std::uint32_t first = next_;
    next_ += static_cast<std::uint32_t>(feature.components);
    Around around{first, {}};
    std::vector<const RestRing*> islands;
    for (const RestRing& ring : feature.rings) {
      look_for_interrupt();
      if (feature.components == 1) {
        join(ring, first);
      } else if (is_around_rest(outlines_, rest_, ring)) {
        join(ring, first + static_cast<std::uint32_t>(around.rings.size()));
        around.rings.push_back(&ring);
      } else {
        islands.push_back(&ring);
      }
    }
    for (const RestRing* island : islands) open_.push_back({island, around});
  }

  /// The rings around a feature's parts of the rest, and the number of the first part.
  struct Around {
    std::uint32_t first;
    std::vector<const RestRing*> rings;
  };
  struct Island {
    const RestRing* ring;
    Around around;
  };

  /// Joins an island's ring to the part of the rest next to the island.
  void settle(const Island& island) {
    const std::vector<std::uint32_t> polygons = polygons_along(*island.ring);
    if (polygons.empty()) return;
    const std::uint32_t part = island.around.first + innermost(island);
    for (const std::uint32_t polygon : polygons) sets_.join(polygon, part);
  }

  /// The ring that goes round an island and round no other ring that does; the first one if all
  /// parts hang together anyway.
  std::uint32_t innermost(const Island& island) {
    const auto& [first, rings] = island.around;
    const auto count = static_cast<std::uint32_t>(rings.size());
    const auto are_one = [&, own = first](std::uint32_t k) {
      return sets_.root(own + k) == sets_.root(own);
    };
    std::uint32_t k = 0;
    while (k < count && are_one(k)) ++k;
    if (k == count) return 0;
    std::uint32_t found = count;
    for (k = 0; k < count; ++k) {
      look_for_interrupt();
      if (!is_within_ring(outlines_, rest_, *rings[k], *island.ring)) continue;
      if (found == count || is_within_ring(outlines_, rest_, *rings[found], *rings[k])) found = k;
    }
    if (found == count) throw std::logic_error("no rest material is next to an island");
    return found;
  }

  void join(const RestRing& ring, std::uint32_t part) {
    for (const std::uint32_t polygon : polygons_along(ring)) sets_.join(polygon, part);
  }

  /// The polygons with edges along a ring, longer than a point.
  std::vector<std::uint32_t> polygons_along(const RestRing& ring) const {
    std::vector<std::uint32_t> found;
    const BoundaryWalks& walks = index_.diagram().walks;
    if (ring.pieces.empty()) {
      for (std::uint32_t k = walks.walks[ring.walk].first; k < walks.walks[ring.walk].last; ++k) {
        if (!walks.sides[k].is_arc) found.push_back(polygon_of(k));
      }
    }
    for (const RestPiece& piece : ring.pieces) {
      if (!piece.is_arc) add_part(outlines_.regions().parts.hidden[piece.number], found);
    }
    return found;
  }

  void add_part(const BoundaryPart& part, std::vector<std::uint32_t>& found) const {
    const DiagramGraph& graph = index_.graph();
    const auto& features = index_.diagram().curves.features;
    const BoundaryWalks& walks = index_.diagram().walks;
    const BoundaryWalk& own = walks.walks[part.walk];
    const std::uint32_t first = graph.halves[part.from].to_side,
                        last = graph.halves[part.to].from_side;
    const auto is_vertex = [&](const RootPoint& foot, std::uint32_t vertex) {
      return are_same(foot, numbers<RootNumber>(features[vertex].centre));
    };
    const bool is_single = first == last && part.vertices.empty();
    if (is_single) {
      const bool is_point = are_same(outlines_.foot(part.from), outlines_.foot(part.to));
      if (!walks.sides[first].is_arc && !is_point) found.push_back(polygon_of(first));
      return;
    }
    bool goes_round = first == last;
    for (std::uint32_t side = first;; side = side + 1 == own.last ? own.first : side + 1) {
      look_for_interrupt();
      const BoundarySide& passed = walks.sides[side];
      const bool is_bare = (side == first && is_vertex(outlines_.foot(part.from), passed.to)) ||
                           (side == last && is_vertex(outlines_.foot(part.to), passed.from));
      if (!passed.is_arc && !is_bare) found.push_back(polygon_of(side));
      if (side == last && !goes_round) break;
      goes_round = false;
    }
  }

  std::uint32_t polygon_of(std::uint32_t side) const {
    return index_.diagram().curves.edges[index_.diagram().walks.sides[side].edge].polygon;
  }

  const RegionOutlines& outlines_;
  const RestMaterial& rest_;
  const DiscIndex& index_;
  std::uint32_t polygons_ = 0, next_ = 0;
  DisjointSets sets_;
  std::vector<Island> open_;
};

}  // namespace

PolygonSet set_to_close(const PolygonSet& P, bool inward) {
  return canonicalize(inward ? outside_of(P).set : P).region;
}

DiscClosing disc_closing(const RegionOutlines& outlines, const RestMaterial& rest) {
  const FloatEnvironment standard;
  return {ClosingRings(outlines, rest).find(), Interior(outlines, rest).count(),
          complement_count(outlines, rest) - 1};
}

}  // namespace minkref::inline disc
