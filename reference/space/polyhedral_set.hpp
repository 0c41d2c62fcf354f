// A sum in space: a regular closed polyhedral set, given by what is exposed in each plane.
#pragma once

#include <string>
#include <vector>

#include "reference/plane/polygon_set.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// The points x with normal · x = offset. The normal is primitive and points away from the set.
struct OrientedPlane {
  IntegerVector normal;
  Rational offset;
  friend bool operator==(const OrientedPlane&, const OrientedPlane&) = default;
};
/// By the normal, coordinate by coordinate, then the offset.
bool operator<(const OrientedPlane& a, const OrientedPlane& b);

/// The first axis along which the normal is not zero; a plane is seen along it as it is, though
/// perhaps mirrored.
std::size_t viewing_axis(const IntegerVector& normal);
/// The two other coordinates, in the order of their axes.
Point seen(const SpacePoint& point, std::size_t axis);
/// Whether what turns counter-clockwise seen from outside turns clockwise as it is seen here.
bool is_mirrored(const OrientedPlane& plane);
/// The point of the plane that is seen there.
SpacePoint lifted(const Point& point, const OrientedPlane& plane);

/// The part of the boundary that lies in one plane with the set below it.
struct PlaneRegion {
  OrientedPlane plane;
  PolygonSet region;  ///< seen along the viewing axis, in canonical form; not empty
  friend bool operator==(const PlaneRegion&, const PlaneRegion&) = default;
};

/// A regular closed polyhedral set, bounded (docs/definitions.md, "Polyhedron"). It may be
/// non-manifold along edges and at vertices. Planes ascend: two sets are equal iff these are.
struct PolyhedralSet {
  std::vector<PlaneRegion> faces;
  bool empty() const { return faces.empty(); }
  friend bool operator==(const PolyhedralSet&, const PolyhedralSet&) = default;
};

/// Canonical JSON (docs/definitions.md, "Canonical form"):
/// `{"planes":[{"normal":["0","0","1"],"offset":"1","region":{"polygons":[...]}},...]}`.
std::string canonical_json(const PolyhedralSet& set);

/// Exact. Linear.
Rational volume(const PolyhedralSet& set);

/// The set that a valid polyhedron bounds: faces in one plane are united. Exact. O(n log n).
PolyhedralSet polyhedral_set(const Polyhedron& surface);

}  // namespace minkref::inline space
