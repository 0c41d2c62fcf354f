#include "reference/plane/routes/paper_route.hpp"

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/boundary/face_boundary.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/routes.hpp"

namespace minkref {
BoundaryGraph paper_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics) {
  return on_exact_frame(P, Q, [&](const auto& frame) {
    statistics.kernel = frame.name();
    const auto [convolution, arrangement] =
        convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    const auto inside = faces_of_sum(arrangement, connected(P) && connected(Q),
                                     face_collision(frame), statistics.orientable_faces);
    const auto& nodes = arrangement;
    BoundaryGraph graph = face_boundary(
        arrangement, inside, [&](std::uint32_t n) { return position(frame, nodes.node(n)); });
    add_counts(statistics, frame.kernel.counts);
    return graph;
  });
}

}  // namespace minkref
