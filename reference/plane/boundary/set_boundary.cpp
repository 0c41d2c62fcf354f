#include "reference/plane/boundary/set_boundary.hpp"

#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/winding_numbers.hpp"
#include "reference/plane/boundary/face_boundary.hpp"

namespace minkref::inline plane {
namespace {

template <class Inside>
SetBoundary boundary_of(const PolygonSet& rings, const Inside& is_inside) {
  return on_exact_frame(rings, {}, [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    std::vector<typename K::Vector> vertices;
    std::vector<IndexedSegment> segments;
    for (const auto& ring : frame.P.rings) {
      if (ring.size() < 3) continue;  // points and segments have no interior
      const auto first = static_cast<std::uint32_t>(vertices.size());
      const auto size = static_cast<std::uint32_t>(ring.size());
      vertices.insert(vertices.end(), ring.begin(), ring.end());
      for (std::uint32_t i = 0; i < size; ++i)
        segments.push_back({first + i, first + (i + 1) % size});
    }
    const Arrangement<K> arrangement(frame.kernel, std::move(vertices), std::move(segments));
    const std::vector<int> winding = winding_numbers(arrangement, [](std::uint32_t) { return 1; });
    std::vector<bool> inside;
    SetBoundary result;
    for (const int number : winding) {
      inside.push_back(is_inside(number));
      result.well_formed = result.well_formed && (number == 0 || number == 1);
    }
    result.graph = face_boundary(
        arrangement, inside, [&](std::uint32_t n) { return position(frame, arrangement.node(n)); });
    return result;
  });
}

}  // namespace

SetBoundary set_boundary(const PolygonSet& rings, int least) {
  return boundary_of(rings, [least](int number) { return number >= least; });
}

SetBoundary set_boundary(const PolygonSet& rings, FillRule rule) {
  switch (rule) {
    case FillRule::positive:
      return set_boundary(rings, 1);
    case FillRule::nonzero:
      return boundary_of(rings, [](int number) { return number != 0; });
    case FillRule::evenodd:
      break;
  }
  return boundary_of(rings, [](int number) { return number % 2 != 0; });
}

Canonical canonicalize(const PolygonSet& rings) {
  const FloatEnvironment standard;
  const SetBoundary boundary = set_boundary(rings);
  Canonical result = canonical_form(boundary.graph);
  result.well_formed = result.well_formed && boundary.well_formed;
  return result;
}

}  // namespace minkref::inline plane
