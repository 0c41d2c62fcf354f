#include "reference/space/polyhedral_set.hpp"

#include <algorithm>
#include <numeric>
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

/// Each face alone, seen in its plane counter-clockwise; planes ascend.
std::vector<PlaneRegion> faces_by_plane(const Polyhedron& surface) {
  const IntegerPoints integers = integer_points(surface.vertices);
  std::vector<PlaneRegion> faces(surface.faces.size());
  std::vector<std::uint32_t> order(faces.size());
  std::iota(order.begin(), order.end(), 0U);
  for (const std::uint32_t f : order) {
    look_for_interrupt();
    const Face& face = surface.faces[f];
    OrientedPlane& plane = faces[f].plane;
    plane.normal = primitive(area_vector(integers.points, face));
    plane.offset =
        Rational(dot(plane.normal, integers.points[face[0]])) / Rational(integers.denominator);
    Ring& ring = faces[f].region.polygons.emplace_back().outer;
    ring.reserve(face.size());
    for (const std::uint32_t v : face) {
      ring.push_back(seen(surface.vertices[v], viewing_axis(plane.normal)));
    }
    if (is_mirrored(plane)) std::reverse(ring.begin(), ring.end());
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    return std::tie(faces[a].plane, a) < std::tie(faces[b].plane, b);
  });
  std::vector<PlaneRegion> sorted;
  sorted.reserve(faces.size());
  for (const std::uint32_t f : order) {
    look_for_interrupt();
    sorted.push_back(std::move(faces[f]));
  }
  return sorted;
}

/// Unites counter-clockwise polygons; a lone triangle only starts at its least corner.
void make_canonical(PolygonSet& region) {
  Ring& first = region.polygons[0].outer;
  if (region.polygons.size() > 1 || first.size() > 3) {
    region = canonicalize(region).region;
    return;
  }
  const auto is_before = [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  };
  std::rotate(first.begin(), std::min_element(first.begin(), first.end(), is_before), first.end());
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
    look_for_interrupt();
    text += text.back() == '[' ? "{" : ",{";
    text += text_of(face.plane) + R"(,"region":)" + canonical_json(face.region) + '}';
  }
  return text + "]}";
}

Rational volume(const PolyhedralSet& set) {
  Rational triple = 0;
  for (const PlaneRegion& face : set.faces) {
    look_for_interrupt();
    const Integer& height = face.plane.normal[viewing_axis(face.plane.normal)];
    triple += face.plane.offset * area(face.region) / Rational(abs(height));
  }
  return triple / 3;
}

PolyhedralSet polyhedral_set(const Polyhedron& surface) {
  const FloatEnvironment standard;
  std::vector<PlaneRegion> faces = faces_by_plane(surface);
  PolyhedralSet set;
  std::size_t planes = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    look_for_interrupt();
    planes += k == 0 || faces[k].plane != faces[k - 1].plane ? 1 : 0;
  }
  set.faces.reserve(planes);
  for (std::size_t k = 0, end = 0; k < faces.size(); k = end) {
    look_for_interrupt();
    PlaneRegion& region = set.faces.emplace_back(std::move(faces[k]));
    for (end = k + 1; end < faces.size() && faces[end].plane == region.plane; ++end) {
      region.region.polygons.push_back(std::move(faces[end].region.polygons[0]));
    }
    make_canonical(region.region);
  }
  return set;
}

}  // namespace minkref::inline space
