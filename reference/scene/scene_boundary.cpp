#include "reference/scene/scene_boundary.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"

namespace minkref::inline scene {
namespace {

/// Calls visit(sum, edge, stretches) for every edge with any.
template <class Visit>
void each_edge(const SceneStretches& stretches, Visit&& visit) {
  for (std::uint32_t sum = 0; sum < stretches.size(); ++sum) {
    for (std::uint32_t edge = 0; edge < stretches[sum]->size(); ++edge) {
      look_for_interrupt();
      const auto& found = (*stretches[sum])[edge];
      if (found) visit(sum, edge, *found);
    }
  }
}

auto key(const OwnedStretch& s) { return std::tuple(s.from, s.to, s.sum, s.edge); }
bool stretch_less(const OwnedStretch& a, const OwnedStretch& b) { return key(a) < key(b); }
bool same_stretch(const OwnedStretch& a, const OwnedStretch& b) {
  return a.from == b.from && a.to == b.to;
}

/// Collects tight stretches, then tight points.
class TightPieces {
 public:
  TightPieces(const PlacedSums& sums, const SceneBoundary& boundary, const AddOwners& add_owners)
      : sums_(sums), boundary_(boundary), add_owners_(add_owners) {}

  void add_pieces(std::uint32_t sum, std::uint32_t edge, const EdgeStretches& found) {
    for (const EdgeStretches::Piece& piece : found.pieces) {
      if (!piece.tight) continue;
      OwnedStretch stretch{number(found, piece.from, sum, edge), number(found, piece.to, sum, edge),
                           sum, edge};
      if (stretch.from > stretch.to) std::swap(stretch.from, stretch.to);
      stretches_.push_back(stretch);
    }
  }

  void add_points(std::uint32_t sum, std::uint32_t edge, const EdgeStretches& found) {
    for (const std::uint32_t k : found.points) {
      const FilteredPoint& point = found.node(k, *sums_[sum], edge);
      if (boundary_.numbers.find(point) != no_entry) continue;
      const std::uint32_t known = numbers_.find(point);
      if (known != no_entry && known < ends_) continue;
      const std::uint32_t at = numbers_.number(point);
      stretches_.push_back({at, at, sum, edge});
      if (k == 0) stretches_.push_back({at, at, sum, sums_[sum]->sum->edges[edge].before});
    }
  }
  /// No more pieces come: points must not end any.
  void end_pieces() { ends_ = numbers_.size(); }

  SceneTightGraph graph() {
    std::sort(stretches_.begin(), stretches_.end(), stretch_less);
    SceneTightGraph result;
    for (const FilteredPoint* point : numbers_.points())
      result.graph.points.push_back(point->exact());
    std::vector<Owner> own;
    for (std::size_t i = 0; i < stretches_.size();) {
      look_for_interrupt();
      const OwnedStretch first = stretches_[i];
      own.clear();
      for (; i < stretches_.size() && same_stretch(first, stretches_[i]); ++i)
        add_owners_(stretches_[i].sum, stretches_[i].edge, result.graph.points[first.from],
                    result.graph.points[first.to], own);
      sort_unique(own);
      TightGraph::Edge edge{first.from, first.to, {}};
      for (const Owner& owner : own) {
        const auto number = static_cast<std::uint32_t>(result.owners.size());
        edge.contacts.push_back({ConvolutionEdge::Kind::S, 1, {0, number}, {}});
        result.owners.push_back(owner);
        result.edge_of_owner.push_back(static_cast<std::uint32_t>(result.graph.edges.size()));
      }
      result.graph.edges.push_back(std::move(edge));
    }
    return result;
  }

 private:
  std::uint32_t number(const EdgeStretches& found, std::uint32_t node, std::uint32_t sum,
                       std::uint32_t edge) {
    return numbers_.number(found.node(node, *sums_[sum], edge));
  }

  const PlacedSums& sums_;
  const SceneBoundary& boundary_;
  const AddOwners& add_owners_;
  PointNumbers numbers_;
  std::uint32_t ends_ = 0;
  std::vector<OwnedStretch> stretches_;
};

/// Numbers for the ends of a sum's stretches: vertices are looked up once.
class EndNumbers {
 public:
  explicit EndNumbers(PointNumbers& numbers) : numbers_(numbers) {}

  std::uint32_t number(const EdgeStretches& found, std::uint32_t node, const PlacedSum& sum,
                       std::uint32_t edge) {
    if (node > 1) return numbers_.number(found.node(node, sum, edge));
    if (sum_ != &sum) {
      sum_ = &sum;
      known_.assign(sum.points.size(), no_entry);
    }
    const SceneSum::Edge& ends = sum.sum->edges[edge];
    std::uint32_t& known = known_[node == 0 ? ends.from : ends.to];
    if (known == no_entry) known = numbers_.number(found.node(node, sum, edge));
    return known;
  }

 private:
  PointNumbers& numbers_;
  const PlacedSum* sum_ = nullptr;
  std::vector<std::uint32_t> known_;  ///< of the vertices of the sum
};

/// Sorts stretches by their points, in time linear in both as a rule.
void sort_stretches(SceneBoundary& boundary) {
  std::vector<std::uint32_t>& first = boundary.first_from;
  first.assign(boundary.numbers.size() + 1, 0);
  for (const OwnedStretch& s : boundary.stretches) ++first[s.from + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> place(first.begin(), first.end() - 1);
  std::vector<OwnedStretch> sorted(boundary.stretches.size());
  for (const OwnedStretch& s : boundary.stretches) sorted[place[s.from]++] = s;
  for (std::size_t p = 0; p + 1 < first.size(); ++p)
    std::sort(sorted.begin() + first[p], sorted.begin() + first[p + 1], stretch_less);
  boundary.stretches = std::move(sorted);
}

}  // namespace

SceneBoundary scene_boundary(const PlacedSums& sums, const SceneStretches& stretches) {
  SceneBoundary boundary;
  EndNumbers ends(boundary.numbers);
  each_edge(stretches, [&](std::uint32_t sum, std::uint32_t edge, const EdgeStretches& found) {
    for (const EdgeStretches::Piece& piece : found.pieces) {
      if (piece.tight) continue;
      const std::uint32_t from = ends.number(found, piece.from, *sums[sum], edge);
      const std::uint32_t to = ends.number(found, piece.to, *sums[sum], edge);
      boundary.stretches.push_back({from, to, sum, edge});
    }
  });
  sort_stretches(boundary);
  return boundary;
}

FilteredBoundary SceneBoundary::graph() const {
  FilteredBoundary graph{numbers.points(), {}};
  graph.edges.reserve(stretches.size());
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (i > 0 && same_stretch(stretches[i - 1], stretches[i])) continue;
    graph.edges.emplace_back(stretches[i].from, stretches[i].to);
  }
  return graph;
}

BoundaryGraph SceneBoundary::exact_graph() const {
  FilteredBoundary ready = graph();
  BoundaryGraph graph{{}, std::move(ready.edges)};
  graph.points.reserve(ready.points.size());
  for (const FilteredPoint* point : ready.points) graph.points.push_back(point->exact());
  return graph;
}

namespace {

/// Calls take(stretch) for the stretches along a side of the region.
template <class Take>
void each_along(const SceneBoundary& boundary, std::uint32_t from, std::uint32_t to, Take&& take) {
  const PointNumbers& points = boundary.numbers;
  const auto& all = boundary.stretches;
  const int way = compare_xy(points[from], points[to]);
  for (std::uint32_t at = from; at != to;) {
    look_for_interrupt();
    std::uint32_t next = no_entry;
    for (std::uint32_t k = boundary.first_from[at]; k < boundary.first_from[at + 1]; ++k) {
      const OwnedStretch& leaving = all[k];
      if (compare_xy(points[at], points[leaving.to]) != way ||
          orientation(points[from], points[to], points[leaving.to]) != 0) {
        continue;
      }
      next = leaving.to;
      take(leaving);
    }
    if (next == no_entry) throw std::logic_error("a side of the union has no stretch");
    at = next;
  }
}

}  // namespace

std::vector<RingOwners> side_owners(const PolygonSet& region, const SceneBoundary& boundary,
                                    const AddOwners& add_owners) {
  std::vector<RingOwners> result;
  const PointNumbers& points = boundary.numbers;
  const auto add_ring = [&](const Ring& ring) {
    RingOwners& owners = result.emplace_back(ring.size());
    std::vector<std::uint32_t> vertices;
    for (const Point& point : ring) {
      vertices.push_back(boundary.numbers.find(FilteredPoint(point)));
      if (vertices.back() == no_entry) throw std::logic_error("a vertex of the union is no node");
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      each_along(
          boundary, vertices[i], vertices[(i + 1) % ring.size()], [&](const OwnedStretch& s) {
            add_owners(s.sum, s.edge, points[s.from].exact(), points[s.to].exact(), owners[i]);
          });
      sort_unique(owners[i]);
    }
  };
  for (const Polygon& polygon : region.polygons) {
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
  }
  return result;
}

SceneTightGraph scene_tight_graph(const PlacedSums& sums, const SceneStretches& stretches,
                                  const SceneBoundary& boundary, const AddOwners& add_owners) {
  TightPieces pieces(sums, boundary, add_owners);
  each_edge(stretches, [&](std::uint32_t sum, std::uint32_t edge, const EdgeStretches& found) {
    pieces.add_pieces(sum, edge, found);
  });
  pieces.end_pieces();
  each_edge(stretches, [&](std::uint32_t sum, std::uint32_t edge, const EdgeStretches& found) {
    pieces.add_points(sum, edge, found);
  });
  return pieces.graph();
}

ScenePassages scene_passages(const SceneTightGraph& tight) {
  ScenePassages result;
  for (TightPassage& passage : passages_along(tight.graph)) {
    ScenePassage& named = result.pieces.emplace_back();
    named.points = std::move(passage.points);
    const std::uint32_t first = SceneTightGraph::number_of_owner(passage.contacts.at(0).at(0));
    result.edges.push_back(tight.edge_of_owner[first]);
    for (const auto& contacts : passage.contacts) {
      std::vector<Owner>& own = named.owners.emplace_back();
      for (const ConvolutionEdge& contact : contacts)
        own.push_back(tight.owners[SceneTightGraph::number_of_owner(contact)]);
      sort_unique(own);
    }
  }
  return result;
}

}  // namespace minkref::inline scene
