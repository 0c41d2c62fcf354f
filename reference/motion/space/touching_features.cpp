#include "reference/motion/space/touching_features.hpp"

#include <algorithm>
#include <tuple>

#include "reference/space/area_vector.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {
namespace {

bool is_on_edge(const SpacePoint& a, const SpacePoint& b, const SpacePoint& p) {
  const SpacePoint to_a = a - p, to_b = b - p;
  return dot(to_a, to_b) <= 0 && is_zero(cross(to_a, to_b));
}

/// Whether a point on a simple face's plane, off the face's border, lies inside the face.
bool is_inside_face(const std::vector<SpacePoint>& ring, const IntegerVector& normal,
                    const SpacePoint& point) {
  const std::size_t axis = viewing_axis(normal);
  const Point p = seen(point, axis);
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = seen(ring[k], axis), b = seen(ring[(k + 1) % ring.size()], axis);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const Rational turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if ((turn > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace

std::optional<SpaceFeature> feature_at(const Polyhedron& operand, const SpacePoint& point) {
  using Kind = SpaceFeature::Kind;
  const std::vector<SpacePoint>& v = operand.vertices;
  for (std::uint32_t k = 0; k < v.size(); ++k) {
    if (v[k] == point) return SpaceFeature{Kind::vertex, k, 0};
  }
  if (operand.is_segment() && is_on_edge(v[0], v[1], point)) return SpaceFeature{Kind::edge, 0, 1};
  std::optional<SpaceFeature> edge, face;
  for (std::uint32_t f = 0; f < operand.faces.size() && !edge; ++f) {
    const Face& ring = operand.faces[f];
    std::vector<SpacePoint> corners;
    for (const std::uint32_t k : ring) corners.push_back(v[k]);
    const IntegerPoints integers = integer_points(corners);
    Face all;
    for (std::uint32_t k = 0; k < ring.size(); ++k) all.push_back(k);
    const IntegerVector normal = primitive(area_vector(integers.points, all));
    const SpacePoint n{Rational(normal[0]), Rational(normal[1]), Rational(normal[2])};
    if (dot(n, point - corners[0]) != 0) continue;
    for (std::size_t k = 0; k < ring.size() && !edge; ++k) {
      const std::uint32_t a = ring[k], b = ring[(k + 1) % ring.size()];
      if (is_on_edge(v[a], v[b], point)) {
        edge = SpaceFeature{Kind::edge, std::min(a, b), std::max(a, b)};
      }
    }
    if (!edge && !face && is_inside_face(corners, normal, point)) {
      face = SpaceFeature{Kind::face, f, 0};
    }
  }
  return edge ? edge : face;
}

std::vector<SpacePoint> touching_points(const SolidPiece& a, const SolidPiece& b) {
  std::vector<SpacePoint> points;
  for (const SpacePoint& p : a.corners) {
    if (b.contains(p)) points.push_back(p);
  }
  for (const SpacePoint& p : b.corners) {
    if (a.contains(p)) points.push_back(p);
  }
  for (const SolidPiece::Edge& first : a.edges) {
    const SpacePoint& from = a.corners[first.from];
    const SpacePoint along = a.corners[first.to] - from;
    for (const SolidPiece::Edge& second : b.edges) {
      const SpacePoint between = b.corners[second.from] - from;
      const SpacePoint other = b.corners[second.to] - b.corners[second.from];
      const SpacePoint n = cross(along, other);
      if (is_zero(n) || dot(n, between) != 0) continue;
      const Rational size = dot(n, n);
      const Rational u = dot(cross(between, other), n) / size;
      const Rational w = dot(cross(between, along), n) / size;
      if (u >= 0 && u <= 1 && w >= 0 && w <= 1) points.push_back(from + u * along);
    }
  }
  std::sort(points.begin(), points.end(), [](const SpacePoint& p, const SpacePoint& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  return points;
}

}  // namespace minkref::inline space
