#include "reference/space/surface/mesh_of.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline space {
namespace {

class FaceCutting {
 public:
  explicit FaceCutting(const SurfaceEdges& surface) : surface_(surface) {}

  /// The mesh faces for one face of the surface.
  std::vector<Face> cut(const SurfaceFace& face, MeshFaces kind) const {
    std::vector<Face> walks;
    for (const std::uint32_t first : face.walks) {
      Face& walk = walks.emplace_back();
      for (const std::uint32_t h : surface_.walk(first)) {
        walk.push_back(surface_.half_edges[h].from);
      }
    }
    for (const std::uint32_t tip : face.tips) walks.push_back({tip});
    if (walks.size() == 1 && is_simple(walks[0]) &&
        (kind == MeshFaces::polygons || walks[0].size() == 3)) {
      return walks;
    }
    return triangles(walks, surface_.planes[face.plane]);
  }

 private:
  static bool is_simple(Face walk) {
    std::sort(walk.begin(), walk.end());
    return std::adjacent_find(walk.begin(), walk.end()) == walk.end();
  }

  std::vector<Face> triangles(std::vector<Face> walks, const OrientedPlane& plane) const {
    const bool mirrored = is_mirrored(plane);
    Face points;
    for (Face& walk : walks) {
      if (mirrored) std::reverse(walk.begin(), walk.end());
      points.insert(points.end(), walk.begin(), walk.end());
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (Face& walk : walks) {
      for (std::uint32_t& p : walk) {
        p = static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) -
                                       points.begin());
      }
    }
    std::vector<FilteredPoint> flat;
    for (const std::uint32_t p : points) {
      flat.emplace_back(seen(surface_.points[p].exact, viewing_axis(plane.normal)));
    }
    const Face outer = std::move(walks[0]);
    walks.erase(walks.begin());
    std::vector<Face> result;
    for (const auto& [a, b, c] : triangulate(flat, outer, walks)) {
      if (orientation(flat[a], flat[b], flat[c]) <= 0) {
        throw std::logic_error("a face was cut into a triangle without area");
      }
      result.push_back(mirrored ? Face{points[a], points[c], points[b]}
                                : Face{points[a], points[b], points[c]});
    }
    return result;
  }

  const SurfaceEdges& surface_;
};

}  // namespace

std::vector<std::vector<Face>> mesh_faces(const SurfaceEdges& surface, MeshFaces faces) {
  const FaceCutting cutting(surface);
  std::vector<std::vector<Face>> result;
  for (const SurfaceFace& face : surface.faces) {
    look_for_interrupt();
    result.push_back(cutting.cut(face, faces));
  }
  return result;
}

Polyhedron mesh_of(const SurfaceEdges& surface, MeshFaces faces) {
  const FloatEnvironment standard;
  Polyhedron mesh;
  for (const SpaceVertex& point : surface.points) mesh.vertices.push_back(point.exact);
  for (auto& parts : mesh_faces(surface, faces)) {
    for (Face& part : parts) mesh.faces.push_back(std::move(part));
  }
  return mesh;
}

}  // namespace minkref::inline space
