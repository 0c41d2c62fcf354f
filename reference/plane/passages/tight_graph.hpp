// An arrangement's tight passages, as a graph.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {

/// Straight edges that meet at points only. An edge from a point to itself means an isolated tight
/// point.
struct TightGraph {
  struct Edge {
    std::uint32_t from = 0, to = 0;
    std::vector<ConvolutionEdge> contacts;
  };
  std::vector<Point> points;
  std::vector<Edge> edges;
};

/// The graph's edges as maximal pieces, in canonical order. Exact.
std::vector<TightPassage> passages_along(const TightGraph& graph);

namespace detail {

/// Whether segments run along a sub-edge both ways. The sum lies left of each segment: no other
/// sub-edge has the sum on both sides and is only touched (Behar & Lien 2012, Sec. 3).
template <class K>
bool runs_both_ways(const Arrangement<K>& arrangement, std::uint32_t h) {
  bool with = false, against = false;
  for (auto cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
    (arrangement.runs_with(h, *cover) ? with : against) = true;
  }
  return with && against;
}

/// Whether `holds` accepts all segments that pass through a node or end there; segments through the
/// node are asked twice.
template <class K, class Holds>
bool all_segments_at(const Arrangement<K>& arrangement, std::uint32_t node, Holds&& holds) {
  return std::all_of(arrangement.leaving_begin(node), arrangement.leaving_end(node),
                     [&](std::uint32_t h) {
                       return std::all_of(arrangement.covers_begin(h), arrangement.covers_end(h),
                                          [&](const auto& cover) { return holds(cover.segment); });
                     });
}

/// Whether no direction leads right of all segments at a node. Otherwise a small motion along such
/// a direction parts everything that touches, or the interiors meet at the node.
template <class K>
bool surrounded(const K& kernel, const Arrangement<K>& arrangement, std::uint32_t node) {
  const auto begin = arrangement.leaving_begin(node), end = arrangement.leaving_end(node);
  const bool crossing = arrangement.provenance(node).vertex == Arrangement<K>::none;
  const auto covered_once = [&](std::uint32_t h) {
    return arrangement.covers_end(h) - arrangement.covers_begin(h) == 1;
  };
  // Two segments that cross, the usual case.
  if (crossing && end - begin == 4 && std::all_of(begin, end, covered_once)) return false;
  // Such a direction exists iff all segments lie within the half-turn left of some segment.
  return all_segments_at(arrangement, node, [&](std::uint32_t first) {
    const auto& rightmost = arrangement.segment_direction(first);
    return !all_segments_at(arrangement, node, [&](std::uint32_t segment) {
      if (segment == first) return true;
      const auto& d = arrangement.segment_direction(segment);
      const int turn = kernel.turn(rightmost, d);
      return turn > 0 || (turn == 0 && same_way(kernel, rightmost, d));
    });
  });
}

template <class K, class Visit>
bool all_faces_at(const Arrangement<K>& arrangement, std::uint32_t node, Visit&& inside) {
  return std::all_of(arrangement.leaving_begin(node), arrangement.leaving_end(node),
                     [&](std::uint32_t h) { return inside(arrangement.face(h)); });
}

}  // namespace detail

/// The tight parts of the arrangement of the reduced convolution `edges`. `position(n)` gives a
/// node's exact point, `inside(face)` whether a face belongs to the sum, `touching(x)` whether sP
/// and x - Q meet with disjoint interiors. As exact as these functions. An open sub-edge is wholly
/// tight or not at all, so one of its points decides; a node counts separately only if it ends no
/// tight sub-edge.
template <class K, class Position, class Inside, class Touching>
TightGraph tight_graph(const K& kernel, const Arrangement<K>& arrangement,
                       const std::vector<ConvolutionEdge>& edges, Position&& position,
                       Inside&& inside, Touching&& touching) {
  TightGraph graph;
  std::vector<std::uint32_t> number(arrangement.node_count(), Arrangement<K>::none);
  const auto add_point = [&](std::uint32_t n, const Point& point) {
    if (number[n] == Arrangement<K>::none) {
      number[n] = static_cast<std::uint32_t>(graph.points.size());
      graph.points.push_back(point);
    }
    return number[n];
  };
  for (std::uint32_t h = 0; h < arrangement.half_edge_count(); h += 2) {
    look_for_interrupt();
    if (!detail::runs_both_ways(arrangement, h)) continue;
    const Point a = position(arrangement.origin(h)), b = position(arrangement.target(h));
    if (!touching(Point{Rational((a.x + b.x) / 2), Rational((a.y + b.y) / 2)})) continue;
    const std::uint32_t from = add_point(arrangement.origin(h), a);
    TightGraph::Edge edge{from, add_point(arrangement.target(h), b), {}};
    for (auto cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
      edge.contacts.push_back(edges[cover->segment]);
    }
    graph.edges.push_back(std::move(edge));
  }
  for (std::uint32_t n = 0; n < arrangement.node_count(); ++n) {
    look_for_interrupt();
    if (number[n] != Arrangement<K>::none || !detail::surrounded(kernel, arrangement, n) ||
        !detail::all_faces_at(arrangement, n, inside)) {
      continue;
    }
    const Point x = position(n);
    if (!touching(x)) continue;
    const std::uint32_t point = add_point(n, x);
    TightGraph::Edge edge{point, point, {}};
    detail::all_segments_at(arrangement, n, [&](std::uint32_t segment) {
      edge.contacts.push_back(edges[segment]);
      return true;
    });
    graph.edges.push_back(std::move(edge));
  }
  return graph;
}

}  // namespace minkref::inline plane
