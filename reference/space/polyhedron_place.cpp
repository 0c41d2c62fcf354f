#include "reference/space/polyhedron_place.hpp"

#include <string>

#include "reference/number/message_number.hpp"

namespace minkref::inline space {
std::string short_text(const SpacePoint& p) {
  return "(" + message_text(p.x) + ", " + message_text(p.y) + ", " + message_text(p.z) + ")";
}

Place place_in(const Polyhedron& polyhedron, std::optional<std::uint32_t> face,
               const std::vector<std::uint32_t>& vertices) {
  Place result;
  if (face) result.face = *face;
  for (const std::uint32_t v : vertices) {
    result.vertices.push_back(v);
    if (v < polyhedron.vertices.size())
      result.coordinates.push_back(short_text(polyhedron.vertices[v]));
  }
  return result;
}

}  // namespace minkref::inline space
