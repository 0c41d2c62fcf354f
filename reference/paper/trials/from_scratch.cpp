#include "reference/paper/trials/from_scratch.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"

namespace minkref {
namespace {

using Position = std::pair<Rational, Rational>;

/// The points on each edge of the reduced convolution, its ends included.
std::vector<std::set<Position>> static_nodes(const PolygonSet& P, const PolygonSet& Q,
                                             const Rational& scale) {
  return on_exact_frame(scaled(P, scale), Q, [](const auto& frame) {
    Statistics statistics;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
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
    std::vector<std::set<Position>> nodes(built.convolution.edges.size());
    for (std::uint32_t h = 0; h < arrangement.half_edge_count(); ++h) {
      for (auto* cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
        nodes[cover->segment].insert(places[arrangement.origin(h)]);
      }
    }
    return nodes;
  });
}

}  // namespace

std::string difference_from_scratch(DynamicSum& dynamic, const PolygonSet& P, const PolygonSet& Q) {
  if (dynamic.empty()) return "";
  DynamicArrangement& arrangement = dynamic.arrangement();
  const Rational& s = arrangement.scale();
  const std::string where = "at " + to_string(s) + ": ";
  const Sum expected = minkowski_sum(P, Q, s), actual = dynamic.sum();
  if (expected.region != actual.region) {
    return where + "expected " + canonical_json(expected.region) + ", got " +
           canonical_json(actual.region);
  }
  if (expected.components != actual.components || expected.holes != actual.holes) {
    return where + "another number of components or holes";
  }
  const auto nodes = static_nodes(P, Q, s);
  const auto& edges = dynamic.states().timeline().events->moving();
  if (nodes.size() != edges.size()) return where + "another number of edges";
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    std::set<Position> mine;
    std::vector<Rational> along;
    const auto add = [&](std::uint32_t node) {
      const Point p = arrangement.position(e, node);
      mine.emplace(p.x, p.y);
      along.push_back(edges[e].d.x() * p.x + edges[e].d.y() * p.y);
    };
    add(start_of_edge);
    for (const std::uint32_t node : arrangement.nodes(e)) add(node);
    add(end_of_edge);
    const std::string edge = " on edge " + std::to_string(e);
    if (!std::is_sorted(along.begin(), along.end())) return where + "nodes out of order" + edge;
    if (mine != nodes[e]) return where + "other nodes" + edge;
  }
  return "";
}

}  // namespace minkref
