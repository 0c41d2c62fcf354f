#include "reference/space/convex/convex_set.hpp"

#include <algorithm>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

bool is_convex_ring(const Ring& ring) {
  const std::size_t count = ring.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % count], &c = ring[(k + 2) % count];
    if ((b.x - a.x) * (c.y - b.y) <= (b.y - a.y) * (c.x - b.x)) return false;
  }
  return true;
}

}  // namespace

std::optional<ConvexPolyhedron> convex_polyhedron(const PolyhedralSet& set) {
  const FloatEnvironment standard;
  if (set.faces.size() < 4) return std::nullopt;
  Polyhedron surface;
  for (const auto& [plane, region] : set.faces) {
    look_for_interrupt();
    if (region.polygons.size() != 1 || !region.polygons[0].holes.empty()) return std::nullopt;
    const Ring& ring = region.polygons[0].outer;
    if (!is_convex_ring(ring)) return std::nullopt;
    Face face;
    for (const Point& corner : ring) {
      face.push_back(static_cast<std::uint32_t>(surface.vertices.size()));
      surface.vertices.push_back(lifted(corner, plane));
    }
    const std::size_t axis = viewing_axis(plane.normal);
    const bool mirrored = axis == 1;  // x and z are seen from the side of negative y
    if ((plane.normal[axis] < 0) != mirrored) std::reverse(face.begin(), face.end());
    surface.faces.push_back(std::move(face));
  }
  try {
    return ConvexPolyhedron(with_shared_vertices(surface));
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

}  // namespace minkref::inline space
