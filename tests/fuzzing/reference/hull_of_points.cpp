#include "tests/fuzzing/reference/hull_of_points.hpp"

#include <algorithm>
#include <set>

namespace minkref::fuzzing {
namespace {

LatticePoint operator-(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::int64_t dot(const LatticePoint& a, const LatticePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LatticePoint cross(const LatticePoint& a, const LatticePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr LatticePoint zero{0, 0, 0};

/// The points in the plane through three points, unless points lie on both sides.
struct Plane {
  LatticePoint normal;
  Face in;
  bool above = false, below = false;

  Plane(const std::vector<LatticePoint>& points, std::size_t a, std::size_t b, std::size_t c)
      : normal(cross(points[b] - points[a], points[c] - points[a])) {
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const std::int64_t height = dot(normal, points[k] - points[a]);
      above = above || height > 0;
      below = below || height < 0;
      if (above && below) return;
      if (height == 0) in.push_back(k);
    }
  }
};

/// Starts at the plane's first point; each step goes to the point that has no other on its right,
/// the farthest such point.
Face corners(const std::vector<LatticePoint>& points, const Face& in, const LatticePoint& outward) {
  Face ring;
  std::uint32_t at = in.front();
  do {
    ring.push_back(at);
    std::uint32_t next = at;
    for (const std::uint32_t k : in) {
      const LatticePoint d = points[next] - points[at], e = points[k] - points[at];
      const std::int64_t turn = dot(outward, cross(d, e));
      if (next == at || turn < 0 || (turn == 0 && dot(e, e) > dot(d, d))) next = k;
    }
    at = next;
  } while (at != ring.front());
  return ring;
}

}  // namespace

Polyhedron hull_of_points(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::set<Face> planes;
  std::vector<Face> rings;
  std::set<std::uint32_t> used;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        const Plane plane(points, a, b, c);
        if (plane.normal == zero || plane.above == plane.below) continue;
        if (!planes.insert(plane.in).second) continue;
        const LatticePoint outward = plane.above ? zero - plane.normal : plane.normal;
        rings.push_back(corners(points, plane.in, outward));
        used.insert(rings.back().begin(), rings.back().end());
      }
    }
  }
  Polyhedron hull;
  std::vector<std::uint32_t> number(points.size());
  for (const std::uint32_t k : used) {
    number[k] = static_cast<std::uint32_t>(hull.vertices.size());
    hull.vertices.push_back({points[k][0], points[k][1], points[k][2]});
  }
  for (Face& ring : rings) {
    for (std::uint32_t& k : ring) k = number[k];
    hull.faces.push_back(std::move(ring));
  }
  return hull;
}

Polyhedron triangulated(const Polyhedron& body) {
  Polyhedron result{body.vertices, {}};
  for (const Face& face : body.faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      result.faces.push_back({face[0], face[k - 1], face[k]});
    }
  }
  return result;
}

}  // namespace minkref::fuzzing
