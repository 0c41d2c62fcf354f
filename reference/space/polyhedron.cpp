#include "reference/space/polyhedron.hpp"

#include <map>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref::inline space {

Rational sextuple_volume(const Polyhedron& polyhedron) {
  const auto [denominator, points] = integer_points(polyhedron.vertices);
  Integer sum = 0;
  for (const Face& face : polyhedron.faces) {
    look_for_interrupt();
    sum += dot(points[face[0]], area_vector(points, face));
  }
  return {sum, denominator * denominator * denominator};
}

Polyhedron with_shared_vertices(const Polyhedron& polyhedron) {
  if (polyhedron.faces.empty()) return polyhedron;
  const auto less = [](const SpacePoint* a, const SpacePoint* b) {
    if (a->x != b->x) return a->x < b->x;
    if (a->y != b->y) return a->y < b->y;
    return a->z < b->z;
  };
  std::map<const SpacePoint*, std::uint32_t, decltype(less)> numbers(less);
  Polyhedron result;
  for (const Face& face : polyhedron.faces) {
    look_for_interrupt();
    Face& renumbered = result.faces.emplace_back();
    for (const std::uint32_t vertex : face) {
      const SpacePoint& point = polyhedron.vertices.at(vertex);
      const auto [at, fresh] =
          numbers.try_emplace(&point, static_cast<std::uint32_t>(result.vertices.size()));
      if (fresh) result.vertices.push_back(point);
      renumbered.push_back(at->second);
    }
  }
  return result;
}

void require_positive(const Scaling& scaling) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (scaling[axis] <= 0) {
      throw BadInput(
          "bad-scale",
          std::string("the factor of the axis ") + "xyz"[axis] + " is " + to_string(scaling[axis]),
          "give a factor above 0 for each axis");
    }
  }
}

Polyhedron scaled(const Polyhedron& polyhedron, const Scaling& by) {
  require_positive(by);
  Polyhedron result = polyhedron;
  for (SpacePoint& v : result.vertices) {
    look_for_interrupt();
    v = {v.x * by[0], v.y * by[1], v.z * by[2]};
  }
  return result;
}

Polyhedron translated(const Polyhedron& polyhedron, const SpacePoint& by) {
  Polyhedron result = polyhedron;
  for (SpacePoint& v : result.vertices) {
    look_for_interrupt();
    v = {v.x + by.x, v.y + by.y, v.z + by.z};
  }
  return result;
}

}  // namespace minkref::inline space
