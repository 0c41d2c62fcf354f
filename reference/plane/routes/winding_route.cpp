// The sum from the full signed convolution: faces with a winding number other than zero (Behar &
// Lien 2012, Sec. 3, after Wein), for operands cut to be simply connected.
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/winding_numbers.hpp"
#include "reference/plane/boundary/face_boundary.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/routes.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline plane {

BoundaryGraph winding_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics) {
  const PolygonSet p = cut_to_simply_connected(P);
  const PolygonSet q = cut_to_simply_connected(Q);
  return on_exact_frame(p, q, [&](const auto& frame) {
    statistics.kernel = frame.name();
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, true, statistics);
    const auto winding = winding_numbers(built.arrangement, [&](std::uint32_t segment) {
      return static_cast<int>(built.convolution.edges[segment].sign);
    });
    std::vector<bool> inside;
    inside.reserve(winding.size());
    for (const int number : winding) {
      // The number counts common components of P and x - Q: a negative number would be our fault.
      if (number < 0) throw std::logic_error("winding route: a negative winding number");
      inside.push_back(number > 0);
    }
    BoundaryGraph graph = face_boundary(built.arrangement, inside, [&](std::uint32_t n) {
      return position(frame, built.arrangement.node(n));
    });
    add_counts(statistics, frame.kernel.counts);
    return graph;
  });
}

}  // namespace minkref::inline plane
