#include "reference/space/polyhedron_place.hpp"

#include <string>

namespace minkref::inline space {
namespace {

std::string shortened(const Rational& coordinate) {
  const std::string text = to_string(coordinate);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

}  // namespace

std::string short_text(const SpacePoint& p) {
  std::string result = "(";
  return result.append(shortened(p.x))
      .append(", ")
      .append(shortened(p.y))
      .append(", ")
      .append(shortened(p.z))
      .append(")");
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
