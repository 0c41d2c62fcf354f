#include "reference/disc/diagram/edge_names.hpp"

#include <algorithm>

namespace minkref::inline disc {
namespace {

/// `sign_beyond(point)` tells whether the foot comes after a point of the edge.
template <class SignBeyond>
VertexId last_before(const OffsetCurves& curves, std::uint32_t edge, Past past,
                     SignBeyond&& sign_beyond) {
  VertexId name = curves.edges[edge].id;
  auto next = std::partition_point(curves.straight.begin(), curves.straight.end(),
                                   [&](const auto& each) { return each.edge < edge; });
  for (; next != curves.straight.end() && next->edge == edge; ++next) {
    const int beyond = sign_beyond(next->at);
    if (beyond < 0 || (beyond == 0 && past == Past::ends)) break;
    name = next->id;
  }
  return name;
}

}  // namespace

VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const DiagramEvent& event,
                   Past past) {
  const Direction& along = diagram.curves.edges[edge].along;
  return last_before(diagram.curves, edge, past, [&](const Point& from) {
    const Interval near = dot(numbers<Interval>(along), event.at - numbers<Interval>(from));
    if (const auto certain = certified_sign(near)) return *certain;
    const auto exact = equidistant_places<RootNumber>(diagram.curves, event.of).at(event.branch);
    return sign(dot(numbers<RootNumber>(along), exact.at - numbers<RootNumber>(from)));
  });
}

VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const Point& vertex,
                   Past past) {
  const Direction& along = diagram.curves.edges[edge].along;
  return last_before(diagram.curves, edge, past,
                     [&](const Point& from) { return sign(dot(along, from_to(from, vertex))); });
}

VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const RootPoint& foot,
                   Past past) {
  const Direction& along = diagram.curves.edges[edge].along;
  return last_before(diagram.curves, edge, past, [&](const Point& from) {
    return sign(dot(numbers<RootNumber>(along), foot - numbers<RootNumber>(from)));
  });
}

}  // namespace minkref::inline disc
