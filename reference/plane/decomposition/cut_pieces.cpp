#include "reference/plane/decomposition/cut_pieces.hpp"

#include <algorithm>
#include <map>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

bool comes_before(const Point& a, const Point& b) { return compare_xy(a, b) < 0; }

/// A graph with the boundary and both sides of all cuts; edges meet at points only.
class CutGraph {
 public:
  explicit CutGraph(const NotchCuts& cuts) : cuts_(cuts) {
    graph_.points = cuts.boundary.points;
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) number_.emplace(graph_.points[p], p);
    const std::size_t walls = cuts.boundary.edges.size() + cuts.cuts.size();
    ends_on_.resize(walls);
    for (const NotchCut& cut : cuts.cuts) {
      look_for_interrupt();
      ends_on_[cut.wall].push_back(number(cut.to));
    }
    for (std::uint32_t wall = 0; wall < walls; ++wall) add(wall);
  }

  const BoundaryGraph& graph() const { return graph_; }
  /// From this edge on, edges are both sides of a cut's part, in turn.
  std::size_t first_slit() const { return first_slit_; }

 private:
  std::uint32_t number(const Point& point) {
    const auto [found, is_new] =
        number_.emplace(point, static_cast<std::uint32_t>(graph_.points.size()));
    if (is_new) graph_.points.push_back(point);
    return found->second;
  }

  /// Divides a wall where cuts end, and adds its parts.
  void add(std::uint32_t wall) {
    const std::size_t edges = cuts_.boundary.edges.size();
    const bool is_cut = wall >= edges;
    if (wall == edges) first_slit_ = graph_.edges.size();
    const auto [from, to] = is_cut ? std::pair(number(cuts_.cuts[wall - edges].from),
                                               number(cuts_.cuts[wall - edges].to))
                                   : cuts_.boundary.edges[wall];
    std::vector<std::uint32_t>& stops = ends_on_[wall];
    stops.push_back(from);
    stops.push_back(to);
    const bool ascends = comes_before(graph_.points[from], graph_.points[to]);
    std::ranges::sort(stops, [&](std::uint32_t a, std::uint32_t b) {
      look_for_interrupt();
      const int order = a == b ? 0 : compare_xy(graph_.points[a], graph_.points[b]);
      return ascends ? order < 0 : order > 0;
    });
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    for (std::size_t k = 1; k < stops.size(); ++k) {
      graph_.edges.emplace_back(stops[k - 1], stops[k]);
      if (is_cut) graph_.edges.emplace_back(stops[k], stops[k - 1]);
    }
  }

  const NotchCuts& cuts_;
  BoundaryGraph graph_;
  std::size_t first_slit_ = no_entry;
  std::map<Point, std::uint32_t, bool (*)(const Point&, const Point&)> number_{&comes_before};
  std::vector<std::vector<std::uint32_t>> ends_on_;  ///< points where cuts end, by wall
};

/// A piece's edges, without its slits.
class PieceBuilder {
 public:
  void add(const BoundaryGraph& all, std::size_t edge) {
    const auto [from, to] = all.edges[edge];
    const std::uint32_t start = number(all, from);
    graph_.edges.emplace_back(start, number(all, to));
  }
  CutPiece build() && { return {canonical_form(graph_).region, std::move(slits)}; }

  std::vector<std::pair<Point, Point>> slits;

 private:
  std::uint32_t number(const BoundaryGraph& all, std::uint32_t point) {
    const auto [found, is_new] =
        number_.emplace(point, static_cast<std::uint32_t>(graph_.points.size()));
    if (is_new) graph_.points.push_back(all.points[point]);
    return found->second;
  }

  BoundaryGraph graph_;
  std::map<std::uint32_t, std::uint32_t> number_;
};

}  // namespace

std::vector<CutPiece> cut_pieces(const NotchCuts& cuts) {
  const FloatEnvironment standard;
  const CutGraph all(cuts);
  const BoundaryGraph& graph = all.graph();
  const Walks walks = boundary_walks(graph);
  const auto piece_of = [&](std::size_t edge) {
    return walks.walks[walks.walk_of[edge]].component;
  };
  std::vector<PieceBuilder> builders(walks.components);
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
    look_for_interrupt();
    PieceBuilder& piece = builders[piece_of(edge)];
    if (edge < all.first_slit()) {
      piece.add(graph, edge);
      continue;
    }
    const bool is_first_side = (edge - all.first_slit()) % 2 == 0;
    if (piece_of(edge) != piece_of(is_first_side ? edge + 1 : edge - 1)) {
      piece.add(graph, edge);
    } else if (is_first_side) {
      const auto [from, to] = graph.edges[edge];
      piece.slits.emplace_back(graph.points[from], graph.points[to]);
    }
  }
  std::vector<CutPiece> pieces;
  pieces.reserve(builders.size());
  for (PieceBuilder& builder : builders) pieces.push_back(std::move(builder).build());
  std::ranges::sort(pieces, [](const CutPiece& a, const CutPiece& b) {
    return std::ranges::lexicographical_compare(a.region.polygons[0].outer,
                                                b.region.polygons[0].outer, comes_before);
  });
  return pieces;
}

}  // namespace minkref::inline plane
