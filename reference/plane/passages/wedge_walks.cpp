#include "reference/plane/passages/wedge_walks.hpp"

#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/lines.hpp"

namespace minkref::inline plane {
namespace {

/// The rings of an operand as segments: segment i runs along edge names[i].
template <class Frame>
struct Boundary {
  std::vector<typename Frame::K::Vector> vertices;
  std::vector<IndexedSegment> segments;
  std::vector<VertexId> names;

  explicit Boundary(const Frame& frame) {
    for (std::uint32_t r = 0; r < frame.P.rings.size(); ++r) {
      const auto& ring = frame.P.rings[r];
      const auto first = static_cast<std::uint32_t>(vertices.size());
      const auto n = static_cast<std::uint32_t>(ring.size());
      vertices.insert(vertices.end(), ring.begin(), ring.end());
      for (std::uint32_t i = 0; i < n; ++i) {
        segments.push_back({first + i, first + (i + 1) % n});
        names.push_back({r, i});
      }
    }
  }
};

template <class K>
bool touches_itself(const Arrangement<K>& arrangement) {
  for (std::uint32_t n = 0; n < arrangement.node_count(); ++n) {
    if (arrangement.leaving_end(n) - arrangement.leaving_begin(n) > 2) return true;
  }
  return false;
}

/// The boundary cycles of the inner faces. Names come from the outgoing edge; if this is the rest
/// of an edge that another ring's vertex cuts, the vertex has the name of the incoming edge's end.
template <class Frame>
WedgeWalks cycles_inside(const Frame& frame, const Boundary<Frame>& boundary,
                         const Arrangement<typename Frame::K>& arrangement) {
  WedgeWalks result;
  const auto segment = [&](std::uint32_t h) { return arrangement.covers_begin(h)->segment; };
  const auto walk = [&](std::uint32_t first) {
    Ring ring;
    auto& edges = result.edge_names.emplace_back();
    auto& vertices = result.vertex_names.emplace_back();
    std::uint32_t h = first;
    do {
      const std::uint32_t next = arrangement.next(h);
      const Point end = position(frame, arrangement.node(arrangement.target(h)));
      const VertexId in = boundary.names[segment(h)], out = boundary.names[segment(next)];
      const auto& rings = frame.P.rings;
      const auto size = static_cast<std::uint32_t>(rings[in.ring].size());
      const auto start = frame.kernel.node(rings[out.ring][out.index]);
      ring.push_back(end);
      edges.push_back(out);
      vertices.push_back(position(frame, start) == end ? out
                                                       : VertexId{in.ring, (in.index + 1) % size});
      h = next;
    } while (h != first);
    result.walks.polygons.push_back({std::move(ring), {}});
  };
  for (std::uint32_t face = 1; face < arrangement.face_count(); ++face) {
    for (const std::uint32_t first : arrangement.cycles(face)) {
      if (arrangement.runs_with(first, *arrangement.covers_begin(first))) walk(first);
    }
  }
  return result;
}

}  // namespace

std::optional<WedgeWalks> wedge_walks(const PolygonSet& set) {
  if (!has_area(set)) return std::nullopt;
  return on_exact_frame(set, PolygonSet{}, [](const auto& frame) -> std::optional<WedgeWalks> {
    const Boundary boundary(frame);
    const Arrangement<typename std::decay_t<decltype(frame)>::K> arrangement(
        frame.kernel, boundary.vertices, boundary.segments);
    if (!touches_itself(arrangement)) return std::nullopt;
    return cycles_inside(frame, boundary, arrangement);
  });
}

ConvolutionEdge in_operands(ConvolutionEdge edge, const std::optional<WedgeWalks>& P,
                            const std::optional<WedgeWalks>& Q) {
  const bool s_edge = edge.kind == ConvolutionEdge::Kind::S;
  const auto &of_edge = s_edge ? P : Q, &of_vertex = s_edge ? Q : P;
  if (of_edge) edge.edge = of_edge->edge_names[edge.edge.ring][edge.edge.index];
  if (of_vertex) edge.vertex = of_vertex->vertex_names[edge.vertex.ring][edge.vertex.index];
  return edge;
}

}  // namespace minkref::inline plane
