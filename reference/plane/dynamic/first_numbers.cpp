// Winding numbers at one scale.
#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/winding_numbers.hpp"
#include "reference/plane/dynamic/edge_happenings.hpp"
#include "reference/plane/dynamic/winding_status.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"

namespace minkref::inline plane {
namespace {

/// The first half-edge along each segment: only this one begins where none ends.
template <class K>
std::vector<std::uint32_t> first_half_edges(const Arrangement<K>& arrangement, std::size_t count) {
  const auto along = [&](auto&& add) {
    for (std::uint32_t h = 0; h < arrangement.half_edge_count(); ++h) {
      for (auto* cover = arrangement.covers_begin(h); cover != arrangement.covers_end(h); ++cover) {
        if (arrangement.runs_with(h, *cover)) add(cover->segment, h);
      }
    }
  };
  const ByEdge<std::uint32_t> half_edges(count, along);
  std::vector<std::uint32_t> first(count);
  std::vector<std::uint32_t> ends;
  for (std::uint32_t segment = 0; segment < count; ++segment) {
    look_for_interrupt();
    ends.clear();
    for (const std::uint32_t h : half_edges.of(segment)) ends.push_back(arrangement.target(h));
    std::sort(ends.begin(), ends.end());
    for (const std::uint32_t h : half_edges.of(segment)) {
      if (!std::binary_search(ends.begin(), ends.end(), arrangement.origin(h))) first[segment] = h;
    }
  }
  return first;
}

}  // namespace

std::vector<SideNumbers> first_numbers(const PolygonSet& P, const PolygonSet& Q,
                                       const Rational& scale) {
  return on_exact_frame(scaled(P, scale), Q, [&](const auto& frame) {
    Statistics statistics;
    const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, true, statistics);
    const auto& edges = built.convolution.edges;
    const auto winding = winding_numbers(built.arrangement, [&](std::uint32_t segment) {
      return static_cast<int>(edges[segment].sign);
    });
    std::vector<SideNumbers> numbers;
    numbers.reserve(edges.size());
    for (const std::uint32_t h : first_half_edges(built.arrangement, edges.size())) {
      numbers.push_back(
          {winding[built.arrangement.face(h)], winding[built.arrangement.face(h ^ 1U)]});
    }
    return numbers;
  });
}

}  // namespace minkref::inline plane
