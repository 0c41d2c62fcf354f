// The edges of faces, each beside the same edge of the next face.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// An edge of a face, along the face's direction.
struct FaceEdge {
  std::uint32_t from, to, face;
  std::pair<std::uint32_t, std::uint32_t> ends() const { return std::minmax(from, to); }
};

/// Lists all faces' edges; edges between the same two vertices stand next to each other, ordered by
/// face. O(n log n).
inline std::vector<FaceEdge> sorted_edges(const std::vector<Face>& faces) {
  std::vector<FaceEdge> edges;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    look_for_interrupt();
    const Face& face = faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.push_back({face[k], face[(k + 1) % face.size()], f});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    look_for_interrupt();
    return std::tuple(a.ends(), a.face) < std::tuple(b.ends(), b.face);
  });
  return edges;
}

}  // namespace minkref::inline space
