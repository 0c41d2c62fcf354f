#include "reference/plane/routes/paper_route.hpp"

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/boundary/face_boundary.hpp"
#include "reference/plane/passages/passages_of_arrangement.hpp"
#include "reference/plane/passages/wedge_walks.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/routes.hpp"

namespace minkref::inline plane {
namespace {

/// Gives the frame, the convolution with its arrangement, and the faces inside the sum to `take`.
template <class Take>
auto with_faces(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics, Take&& take) {
  return on_exact_frame(P, Q, [&](const auto& frame) {
    statistics.kernel = frame.name();
    auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
    const auto inside =
        faces_of_sum(built.arrangement, P, Q, face_collision(frame), statistics.orientable_faces);
    return take(frame, built, inside);
  });
}

}  // namespace

BoundaryGraph paper_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics,
                          std::vector<TightPassage>* passages) {
  return with_faces(P, Q, statistics, [&](const auto& frame, auto& built, const auto& inside) {
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

BoundaryOnConvolution paper_route_on_convolution(const PolygonSet& P, const PolygonSet& Q,
                                                 Statistics& statistics) {
  return with_faces(P, Q, statistics, [&](const auto& frame, auto& built, const auto& inside) {
    BoundaryOnConvolution result;
    const auto& arrangement = built.arrangement;
    const auto below = [&](std::uint32_t h) {
      // No edge runs along a face outside, so one runs along this side of the face inside.
      auto cover = arrangement.covers_begin(h);
      while (!arrangement.runs_with(h, *cover)) ++cover;
      result.below.push_back(cover->segment);
    };
    const auto place = [&](std::uint32_t n) { return position(frame, arrangement.node(n)); };
    result.graph = face_boundary(arrangement, inside, place, below);
    add_counts(statistics, frame.kernel.counts);
    result.convolution = std::move(built.convolution.edges);
    return result;
  });
}

}  // namespace minkref::inline plane
