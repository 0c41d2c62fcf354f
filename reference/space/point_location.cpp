#include "reference/space/point_location.hpp"

#include <optional>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

Rational along(const OrientedPlane& plane, const SpacePoint& x) {
  const IntegerVector& n = plane.normal;
  return Rational(n[0]) * x.x + Rational(n[1]) * x.y + Rational(n[2]) * x.z;
}

Location on_plane(const PlaneRegion& face, const SpacePoint& x) {
  return locate(face.region, seen(x, viewing_axis(face.plane.normal)));
}

bool lies_on(const PlaneRegion& face, const SpacePoint& x) {
  return along(face.plane, x) == face.plane.offset && on_plane(face, x) != Location::outside;
}

/// Whether the open ray from a point off the face crosses the face; nothing if the ray meets the
/// face's border, or runs within its plane.
std::optional<bool> crosses(const SpacePoint& from, const SpacePoint& direction,
                            const PlaneRegion& face) {
  const Rational slope = along(face.plane, direction);
  const Rational height = face.plane.offset - along(face.plane, from);
  if (slope == 0 && height == 0) return std::nullopt;
  if (slope == 0 || sign(slope) * sign(height) <= 0) return false;
  const Rational t = height / slope;
  const SpacePoint met{from.x + t * direction.x, from.y + t * direction.y,
                       from.z + t * direction.z};
  const Location where = on_plane(face, met);
  if (where == Location::boundary) return std::nullopt;
  return where == Location::inside;
}

/// Whether the ray leaves an odd number of times; nothing if some face does not tell.
std::optional<bool> leaves(const PolyhedralSet& set, const SpacePoint& from,
                           const SpacePoint& direction) {
  bool odd = false;
  for (const PlaneRegion& face : set.faces) {
    look_for_interrupt();
    const std::optional<bool> crossed = crosses(from, direction, face);
    if (!crossed) return std::nullopt;
    odd ^= *crossed;
  }
  return odd;
}

}  // namespace

Location locate(const PolyhedralSet& set, const SpacePoint& point) {
  for (const PlaneRegion& face : set.faces) {
    look_for_interrupt();
    if (lies_on(face, point)) return Location::boundary;
  }
  // A plane through the point and an edge, and a plane of faces, has at most two directions
  // (1, k, k²): few k fail.
  for (int k = 1;; ++k) {
    const SpacePoint direction{1, k, Rational(k) * k};
    if (const std::optional<bool> inside = leaves(set, point, direction)) {
      return *inside ? Location::inside : Location::outside;
    }
  }
}

}  // namespace minkref::inline space
