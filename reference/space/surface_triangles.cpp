#include "reference/space/surface_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/polyhedron_place.hpp"

namespace minkref::inline space {
namespace {

constexpr std::uint32_t no_shell = UINT32_MAX;

/// A triangle's side on an edge of the surface, or on a face's diagonal.
struct TriangleSide {
  std::uint32_t least, most;
  std::uint32_t diagonal_of;  ///< face + 1, or 0 for an edge
  std::uint32_t triangle, place;
  auto edge() const { return std::tuple(least, most, diagonal_of); }
};

void join_sides(std::vector<SurfaceTriangle>& triangles, const std::vector<Face>& faces) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * triangles.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // of the face at hand, sorted
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t f = triangles[t].face;
    if (t == 0 || triangles[t - 1].face != f) {
      look_for_interrupt();
      edges.clear();
      const Face& face = faces[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        edges.emplace_back(face[k], face[(k + 1) % face.size()]);
      }
      std::sort(edges.begin(), edges.end());
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t].corners[k], to = triangles[t].corners[(k + 1) % 3];
      const bool edge = std::binary_search(edges.begin(), edges.end(), std::pair(from, to));
      sides.push_back({std::min(from, to), std::max(from, to), edge ? 0 : f + 1, t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    look_for_interrupt();
    return a.edge() < b.edge();
  });
  for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
    triangles[sides[k].triangle].beyond[sides[k].place] = sides[k + 1].triangle;
    triangles[sides[k + 1].triangle].beyond[sides[k + 1].place] = sides[k].triangle;
  }
}

void number_shells(std::vector<SurfaceTriangle>& triangles) {
  std::uint32_t shells = 0;
  std::vector<std::uint32_t> left;
  for (std::uint32_t start = 0; start < triangles.size(); ++start) {
    if (triangles[start].shell != no_shell) continue;
    triangles[start].shell = shells;
    for (left.push_back(start); !left.empty();) {
      look_for_interrupt();
      const std::uint32_t t = left.back();
      left.pop_back();
      for (const std::uint32_t next : triangles[t].beyond) {
        if (triangles[next].shell != no_shell) continue;
        triangles[next].shell = shells;
        left.push_back(next);
      }
    }
    ++shells;
  }
}

}  // namespace

std::vector<SurfaceTriangle> surface_triangles(const std::vector<Face>& faces,
                                               const VertexSigns& signs) {
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    look_for_interrupt();
    const auto cut = face_triangles(faces[f], signs);
    if (!cut) {
      Place place;
      place.face = f;
      throw BadInput("face-not-simple", "the edges of a face meet each other",
                     "split the face where it meets itself, or move a vertex", std::move(place));
    }
    for (const TriangleCorners& corners : *cut) triangles.push_back({corners, {}, f, no_shell});
  }
  join_sides(triangles, faces);
  number_shells(triangles);
  return triangles;
}

SpaceBoxTree box_tree(const std::vector<SurfaceTriangle>& triangles, const VertexSigns& signs) {
  std::vector<SpaceBox> boxes;
  boxes.reserve(triangles.size());
  for (const SurfaceTriangle& triangle : triangles) {
    look_for_interrupt();
    SpaceBox& box = boxes.emplace_back();
    for (const std::uint32_t v : triangle.corners) box.add(signs.box(v));
  }
  return SpaceBoxTree(std::move(boxes));
}

}  // namespace minkref::inline space
