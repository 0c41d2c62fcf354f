// The convolution's compatibility rule as defined, edge by vertex.
#pragma once

#include <tuple>

#include "reference/plane/convolution/between.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "tests/plane/ray_casting.hpp"

namespace minkref::testing {

struct Corner {
  VertexId id;
  Point in, out;  ///< directions of the edges at the vertex
};

inline std::vector<Corner> corners(const PolygonSet& set) {
  std::vector<Corner> all;
  std::uint32_t number = 0;
  for_each_ring(set, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      all.push_back({{number, static_cast<std::uint32_t>(i)},
                     ring[i] - ring[(i + n - 1) % n],
                     ring[(i + 1) % n] - ring[i]});
    }
    ++number;
  });
  return all;
}

inline bool same_direction(const Point& a, const Point& b) {
  return sign(cross(a, b)) == 0 && sign(dot(a, b)) > 0;
}

/// Whether d lies in the open counter-clockwise turn (less than 180 degrees) from a to b.
inline bool strictly_between(const Point& a, const Point& d, const Point& b) {
  return sign(cross(a, d)) > 0 && sign(cross(d, b)) > 0;
}

/// 1 at a strictly convex vertex, -1 at a reflex vertex if d lies in the turn, else 0. `first`,
/// `last`: the ends that the turn includes.
inline int compatible(const Point& d, const Corner& corner, bool first, bool last) {
  const int turn = sign(cross(corner.in, corner.out));
  if (turn == 0) return 0;
  const Point& from = turn > 0 ? corner.in : corner.out;
  const Point& to = turn > 0 ? corner.out : corner.in;
  const bool in_turn = strictly_between(from, d, to) || (first && same_direction(d, from)) ||
                       (last && same_direction(d, to));
  return in_turn ? turn : 0;
}

/// All edges of the convolution, S-edges first; `full` with the reflex vertices.
inline std::vector<ConvolutionEdge> convolution_by_definition(
    const PolygonSet& P, const PolygonSet& Q, bool full, Between between = Between::half_open) {
  using Kind = ConvolutionEdge::Kind;
  std::vector<ConvolutionEdge> all;
  for (const Kind kind : {Kind::S, Kind::T}) {
    for (const Corner& edge : corners(kind == Kind::S ? P : Q)) {
      for (const Corner& vertex : corners(kind == Kind::S ? Q : P)) {
        const bool both = between == Between::closed, half = between == Between::half_open;
        const int sign = compatible(edge.out, vertex, both || (half && kind == Kind::S),
                                    both || (half && kind == Kind::T));
        if (sign > 0 || (full && sign < 0)) {
          all.push_back({kind, static_cast<std::int8_t>(sign), edge.id, vertex.id});
        }
      }
    }
  }
  return all;
}

inline bool less_edge(const ConvolutionEdge& a, const ConvolutionEdge& b) {
  const auto key = [](const ConvolutionEdge& e) {
    return std::tuple(e.kind, e.edge.ring, e.edge.index, e.vertex.ring, e.vertex.index, e.sign);
  };
  return key(a) < key(b);
}

inline std::vector<ConvolutionEdge> sorted(std::vector<ConvolutionEdge> all) {
  std::sort(all.begin(), all.end(), less_edge);
  return all;
}

}  // namespace minkref::testing
