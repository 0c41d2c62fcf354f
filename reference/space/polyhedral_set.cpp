#include "reference/space/polyhedral_set.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/space/area_vector.hpp"

namespace minkref::inline space {
namespace {

std::string text_of(const OrientedPlane& plane) {
  const IntegerVector& n = plane.normal;
  return R"("normal":[")" + n[0].str() + R"(",")" + n[1].str() + R"(",")" + n[2].str() +
         R"("],"offset":")" + to_string(plane.offset) + '"';
}

}  // namespace

bool operator<(const OrientedPlane& a, const OrientedPlane& b) {
  return std::tie(a.normal, a.offset) < std::tie(b.normal, b.offset);
}

std::size_t viewing_axis(const IntegerVector& normal) {
  std::size_t axis = 0;
  while (axis < 2 && normal[axis].is_zero()) ++axis;
  return axis;
}

Point seen(const SpacePoint& point, std::size_t axis) {
  if (axis == 0) return {point.y, point.z};
  if (axis == 1) return {point.x, point.z};
  return {point.x, point.y};
}

bool is_mirrored(const OrientedPlane& plane) {
  // A view from the second axis's positive end mirrors the plane.
  const std::size_t axis = viewing_axis(plane.normal);
  return (plane.normal[axis].sign() > 0) == (axis == 1);
}

SpacePoint lifted(const Point& point, const OrientedPlane& plane) {
  const IntegerVector& n = plane.normal;
  const std::size_t axis = viewing_axis(n);
  const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  const Rational rest = plane.offset - Rational(n[first]) * point.x - Rational(n[second]) * point.y;
  const Rational height = rest / Rational(n[axis]);
  if (axis == 0) return {height, point.x, point.y};
  if (axis == 1) return {point.x, height, point.y};
  return {point.x, point.y, height};
}

std::string canonical_json(const PolyhedralSet& set) {
  std::string text = R"({"planes":[)";
  for (const PlaneRegion& face : set.faces) {
    text += text.back() == '[' ? "{" : ",{";
    text += text_of(face.plane) + R"(,"region":)" + canonical_json(face.region) + '}';
  }
  return text + "]}";
}

Rational volume(const PolyhedralSet& set) {
  Rational triple = 0;
  for (const PlaneRegion& face : set.faces) {
    const Integer& height = face.plane.normal[viewing_axis(face.plane.normal)];
    triple += face.plane.offset * area(face.region) / Rational(abs(height));
  }
  return triple / 3;
}

PolyhedralSet polyhedral_set(const Polyhedron& surface) {
  const FloatEnvironment standard;
  const IntegerPoints integers = integer_points(surface.vertices);
  std::map<OrientedPlane, PolygonSet> planes;
  for (const Face& face : surface.faces) {
    const IntegerVector normal = primitive(area_vector(integers.points, face));
    const OrientedPlane plane{
        normal, Rational(dot(normal, integers.points[face[0]])) / Rational(integers.denominator)};
    Ring ring;
    for (const std::uint32_t v : face) {
      ring.push_back(seen(surface.vertices[v], viewing_axis(normal)));
    }
    planes[plane].polygons.push_back({std::move(ring), {}});
  }
  PolyhedralSet set;
  for (auto& [plane, rings] : planes) {
    look_for_interrupt();
    orient(rings);
    set.faces.push_back({plane, canonicalize(rings).region});
  }
  return set;
}

}  // namespace minkref::inline space
