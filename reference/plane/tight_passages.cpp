#include "reference/plane/tight_passages.hpp"

#include <optional>

#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/passages/passages_of_arrangement.hpp"
#include "reference/plane/passages/wedge_walks.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/paper_route.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {
namespace {

/// Requires P already scaled; `rings_p` and `rings_q` are the convolution's operands.
TightGraph graph_of(const PolygonSet& P, const PolygonSet& Q, const PolygonSet& rings_p,
                    const PolygonSet& rings_q) {
  return on_exact_frame(rings_p, rings_q, [&](const auto& frame) {
    Statistics statistics;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    // Nobody asks for most faces.
    std::vector<std::optional<bool>> inside(built.arrangement.face_count());
    std::optional<decltype(face_collision(frame))> collision;
    const auto meets = [&](const auto& arrangement, std::uint32_t face) {
      if (!collision) collision.emplace(face_collision(frame));
      return (*collision)(arrangement, face);
    };
    return tight_graph_of_arrangement(
        frame, built.arrangement, built.convolution.edges, P, Q, [&](std::uint32_t face) {
          if (!inside[face]) {
            inside[face] = face_in_sum(built.arrangement, face, connected(P) && connected(Q), meets,
                                       statistics.orientable_faces);
          }
          return *inside[face];
        });
  });
}

}  // namespace

std::vector<TightPassage> tight_passages(const PolygonSet& P, const PolygonSet& Q,
                                         const Rational& scale) {
  const FloatEnvironment standard;
  refuse_bad_operands(P, Q, scale);
  if (P.empty() || Q.empty()) return {};
  const PolygonSet p = scaled(P, scale);
  const auto walks_p = wedge_walks(p), walks_q = wedge_walks(Q);
  TightGraph graph = graph_of(p, Q, walks_p ? walks_p->walks : p, walks_q ? walks_q->walks : Q);
  for (TightGraph::Edge& edge : graph.edges) {
    for (ConvolutionEdge& contact : edge.contacts) contact = in_operands(contact, walks_p, walks_q);
  }
  return passages_along(graph);
}

}  // namespace minkref::inline plane
