// A sum in space: a regular closed polyhedral set, given as the exposed part for each plane.
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
/// Compares the normals, coordinate after coordinate, then the offsets.
bool operator<(const OrientedPlane& a, const OrientedPlane& b);

/// The first axis with a nonzero normal coordinate; a view along this axis shows the plane
/// faithfully, though perhaps mirrored.
std::size_t viewing_axis(const IntegerVector& normal);
/// The two remaining coordinates, ordered by axis.
Point seen(const SpacePoint& point, std::size_t axis);
/// Whether a turn counter-clockwise as seen from outside runs clockwise in this view.
bool is_mirrored(const OrientedPlane& plane);
/// The plane's point that the view shows at `point`.
SpacePoint lifted(const Point& point, const OrientedPlane& plane);

/// The boundary's part within one plane, with the set below.
struct PlaneRegion {
  OrientedPlane plane;
  PolygonSet region;  ///< seen along the viewing axis, in canonical form; not empty
  friend bool operator==(const PlaneRegion&, const PlaneRegion&) = default;
};

/// A regular closed polyhedral set, bounded (docs/definitions.md, "Polyhedron"). It may be
/// non-manifold along edges and at vertices. Planes ascend: two sets are equal iff their faces are
/// equal.
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

/// The set that a valid polyhedron bounds, with coplanar faces united. Exact. O(n log n).
PolyhedralSet polyhedral_set(const Polyhedron& surface);

}  // namespace minkref::inline space
