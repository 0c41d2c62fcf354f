#include "reference/paper/trials/from_scratch.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/winding_numbers.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref {
namespace {

using Position = std::pair<Rational, Rational>;

/// An edge from scratch: its points, its ends included, and the winding numbers beside each piece,
/// by the start of the piece.
struct StaticEdge {
  std::set<Position> nodes;
  std::map<Position, SideNumbers> numbers;
};

std::vector<StaticEdge> static_edges(const PolygonSet& P, const PolygonSet& Q,
                                     const Rational& scale, ConvolutionType of) {
  return on_exact_frame(scaled(P, scale), Q, [of](const auto& frame) {
    Statistics statistics;
    const bool full = of == ConvolutionType::full;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, full, statistics);
    const auto& arrangement = built.arrangement;
    std::vector<Position> places;
    for (std::uint32_t n = 0; n < arrangement.node_count(); ++n) {
      Point p;
      if constexpr (requires { frame.position(arrangement.node(n)); }) {
        p = frame.position(arrangement.node(n));
      } else {
        p = position(frame, arrangement.node(n));
      }
      places.emplace_back(p.x, p.y);
    }
    const auto winding = winding_numbers(arrangement, [&](std::uint32_t segment) {
      return static_cast<int>(built.convolution.edges[segment].sign);
    });
    std::vector<StaticEdge> edges(built.convolution.edges.size());
    for (std::uint32_t h = 0; h < arrangement.half_edge_count(); ++h) {
      for (auto* cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
        const Position& place = places[arrangement.origin(h)];
        StaticEdge& edge = edges[cover->segment];
        edge.nodes.insert(place);
        if (!arrangement.runs_with(h, *cover)) continue;
        edge.numbers[place] = {winding[arrangement.face(h)], winding[arrangement.face(h ^ 1U)]};
      }
    }
    return edges;
  });
}

}  // namespace

std::string difference_from_scratch(DynamicSum& dynamic, const PolygonSet& P, const PolygonSet& Q) {
  if (dynamic.empty()) return "";
  DynamicArrangement& arrangement = dynamic.arrangement();
  const Rational& s = arrangement.scale();
  const std::string where = "at " + to_string(s) + ": ";
  const ConvolutionType of = dynamic.followed();
  const Route route = of == ConvolutionType::full ? Route::winding : Route::paper;
  const Sum expected = minkowski_sum(P, Q, s, route), actual = dynamic.sum();
  if (expected.region != actual.region) {
    return where + "expected " + canonical_json(expected.region) + ", got " +
           canonical_json(actual.region);
  }
  if (expected.components != actual.components || expected.holes != actual.holes) {
    return where + "another number of components or holes";
  }
  const auto from_scratch = static_edges(followed_operand(P, of), followed_operand(Q, of), s, of);
  const auto& edges = dynamic.states().timeline().events->moving();
  if (from_scratch.size() != edges.size()) return where + "another number of edges";
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    std::vector<Position> mine;
    std::vector<Rational> along;
    const auto add = [&](std::uint32_t node) {
      const Point p = arrangement.position(e, node);
      mine.emplace_back(p.x, p.y);
      along.push_back(edges[e].d.x() * p.x + edges[e].d.y() * p.y);
    };
    add(start_of_edge);
    for (const std::uint32_t node : arrangement.nodes(e)) add(node);
    add(end_of_edge);
    const std::string edge = " on edge " + std::to_string(e);
    if (!std::is_sorted(along.begin(), along.end())) return where + "nodes out of order" + edge;
    if (std::set(mine.begin(), mine.end()) != from_scratch[e].nodes) {
      return where + "other nodes" + edge;
    }
    if (of != ConvolutionType::full) continue;
    const std::vector<SideNumbers> numbers = arrangement.winding_numbers(e);
    for (std::size_t i = 0; i + 1 < mine.size(); ++i) {
      if (mine[i] == mine[i + 1] || numbers[i] == from_scratch[e].numbers.at(mine[i])) continue;
      return where + "other winding numbers" + edge;
    }
  }
  return "";
}

}  // namespace minkref
