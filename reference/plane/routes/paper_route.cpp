#include "reference/plane/routes/paper_route.hpp"

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/boundary/face_boundary.hpp"
#include "reference/plane/passages/passages_of_arrangement.hpp"
#include "reference/plane/passages/wedge_walks.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/routes.hpp"

namespace minkref::inline plane {
BoundaryGraph paper_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics,
                          std::vector<TightPassage>* passages) {
  return on_exact_frame(P, Q, [&](const auto& frame) {
    statistics.kernel = frame.name();
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    const auto inside =
        faces_of_sum(built.arrangement, P, Q, face_collision(frame), statistics.orientable_faces);
    BoundaryGraph graph = face_boundary(built.arrangement, inside, [&](std::uint32_t n) {
      return position(frame, built.arrangement.node(n));
    });
    add_counts(statistics, frame.kernel.counts);
    if (passages != nullptr) {
      // With touching rings, another convolution than the boundary's holds the passages.
      const bool apart = !wedge_walks(P) && !wedge_walks(Q);
      *passages = apart ? passages_along(tight_graph_of_arrangement(
                              frame, built.arrangement, built.convolution.edges, P, Q,
                              [&](std::uint32_t face) -> bool { return inside[face]; }))
                        : tight_passages(P, Q, 1);
    }
    return graph;
  });
}

}  // namespace minkref::inline plane
