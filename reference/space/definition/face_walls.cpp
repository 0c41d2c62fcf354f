#include "reference/space/definition/face_walls.hpp"

#include <map>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "reference/space/area_vector.hpp"

namespace minkref::inline space {
namespace {

/// Whether a simple ring, seen counter-clockwise, turns right nowhere.
bool is_convex_ring(const Ring& ring) {
  const std::vector<FilteredPoint> points(ring.begin(), ring.end());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t second = (k + 1) % points.size(), third = (k + 2) % points.size();
    if (orientation(points[k], points[second], points[third]) < 0) return false;
  }
  return true;
}

}  // namespace

FaceWalls face_walls(const Polyhedron& surface) {
  const IntegerPoints integers = integer_points(surface.vertices);
  std::vector<SolidCorner> corners;
  for (const IntegerVector& point : integers.points) {
    corners.push_back(solid_corner(point, integers.denominator));
  }
  std::map<OrientedPlane, std::uint32_t> numbers;
  FaceWalls result;
  for (const Face& face : surface.faces) {
    look_for_interrupt();
    const IntegerVector normal = primitive(area_vector(integers.points, face));
    const OrientedPlane plane{
        normal, Rational(dot(normal, integers.points[face[0]])) / Rational(integers.denominator)};
    const auto [at, fresh] =
        numbers.try_emplace(plane, static_cast<std::uint32_t>(result.planes.size()));
    const std::uint32_t cut = at->second;
    if (fresh) {
      numbers.emplace(reversed(plane), cut + 1);
      result.planes.emplace_back(plane);
      result.planes.emplace_back(reversed(plane));
    }
    Ring ring;
    CornerRing whole;
    for (const std::uint32_t v : face) {
      ring.push_back(seen(surface.vertices[v], viewing_axis(normal)));
      whole.push_back(corners[v]);
    }
    PolygonSet polygon{{{std::move(ring), {}}}};
    orient(polygon);
    if (is_convex_ring(polygon.polygons[0].outer)) {
      result.walls.push_back({cut, std::move(whole)});
      continue;
    }
    for (const Triangle& triangle : triangulate(polygon)) {
      CornerRing part;
      for (const Point& point : triangle) part.push_back(solid_corner(lifted(point, plane)));
      result.walls.push_back({cut, std::move(part)});
    }
  }
  return result;
}

}  // namespace minkref::inline space
