#include "reference/plane/convolution/convolution_size.hpp"

#include "reference/number/float_environment.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {

std::uint64_t convolution_size(const PolygonSet& P, const PolygonSet& Q, bool full,
                               Between between) {
  const FloatEnvironment standard;
  return on_exact_frame(P, Q, [&](const auto& frame) {
    std::uint64_t size = 0;
    const auto count = [&](VertexId, VertexId, int) { ++size; };
    compatible_pairs(frame.kernel, detail::edges_by_angle(frame.kernel, frame.P), frame.Q,
                     ends_for_s_edges(between), full, count);
    compatible_pairs(frame.kernel, detail::edges_by_angle(frame.kernel, frame.Q), frame.P,
                     ends_for_t_edges(between), full, count);
    return size;
  });
}

}  // namespace minkref::inline plane
