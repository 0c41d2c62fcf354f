#include "reference/motion/space/contact_scales.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/motion/strip_polygon.hpp"
#include "reference/space/face_triangles.hpp"

namespace minkref::inline space {
namespace {

/// An operand's parts for contacts: vertices with their outgoing edges, edges with a direction into
/// each adjacent face, faces as triangles.
struct TouchingParts {
  struct Edge {
    SpacePoint from, along;
    std::vector<SpacePoint> into_faces;
  };
  struct Triangle {
    std::array<SpacePoint, 3> corners;
    SpacePoint normal;
  };
  struct Vertex {
    SpacePoint at;
    std::vector<SpacePoint> leaving;
  };
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;

  explicit TouchingParts(const Polyhedron& operand) {
    for (const SpacePoint& p : operand.vertices) vertices.push_back({p, {}});
    const auto add_edge = [&](std::uint32_t a, std::uint32_t b) -> Edge& {
      const SpacePoint &from = operand.vertices[a], &to = operand.vertices[b];
      vertices[a].leaving.push_back(to - from);
      vertices[b].leaving.push_back(from - to);
      return edges.emplace_back(Edge{from, to - from, {}});
    };
    if (operand.is_segment()) add_edge(0, 1);
    const IntegerPoints integers = integer_points(operand.vertices);
    const VertexSigns signs(integers.points);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers;
    for (const Face& face : operand.faces) {
      const auto cut = face_triangles(face, signs);
      if (!cut) throw std::logic_error("a face of a valid operand has no triangles");
      SpacePoint normal;
      for (const TriangleCorners& t : *cut) {
        const SpacePoint &a = operand.vertices[t[0]], &b = operand.vertices[t[1]],
                         &c = operand.vertices[t[2]];
        normal = cross(b - a, c - a);
        triangles.push_back({{a, b, c}, normal});
        if (operand.faces.size() == 1) triangles.push_back({{a, c, b}, Rational(-1) * normal});
      }
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::uint32_t a = face[k], b = face[(k + 1) % face.size()];
        const auto [at, fresh] = numbers.try_emplace(std::minmax(a, b), edges.size());
        if (fresh) add_edge(a, b);
        edges[at->second].into_faces.push_back(
            cross(normal, operand.vertices[b] - operand.vertices[a]));
      }
    }
  }
};

bool are_all(const std::vector<SpacePoint>& ways, const SpacePoint& normal, int side) {
  return std::all_of(ways.begin(), ways.end(),
                     [&](const SpacePoint& way) { return side * sign(dot(normal, way)) >= 0; });
}

bool is_in(const TouchingParts::Triangle& triangle, const SpacePoint& p) {  // in its plane
  for (std::size_t k = 0; k < 3; ++k) {
    const SpacePoint& from = triangle.corners[k];
    const SpacePoint along = triangle.corners[(k + 1) % 3] - from;
    if (dot(cross(triangle.normal, along), p - from) < 0) return false;
  }
  return true;
}

class ContactScales {
 public:
  ContactScales(const Polyhedron& part, const Polyhedron& obstacles,
                const std::vector<SpacePoint>& path)
      : part_(part), obstacles_(obstacles), path_(path) {}

  std::vector<Rational> run() {
    for (std::size_t k = 0; k < path_.size(); ++k) {
      at_vertex(path_[k]);
      if (k + 1 < path_.size() || path_.size() == 1) {
        along(path_[k], path_[std::min(k + 1, path_.size() - 1)]);
      }
    }
    std::sort(scales_.begin(), scales_.end());
    scales_.erase(std::unique(scales_.begin(), scales_.end()), scales_.end());
    return std::move(scales_);
  }

 private:
  void add(const Rational& scale) {
    if (scale > 0) scales_.push_back(scale);
  }

  /// x + s r on an edge of O, or x + s (a point of an edge of R) = o.
  void along(const SpacePoint& from, const SpacePoint& to) {
    const SpacePoint way = to - from;
    for (const auto& edge : obstacles_.edges) {
      look_for_interrupt();
      for (const auto& vertex : part_.vertices) {
        // from + t way + s r = e + u along.
        meet(way, vertex.at, Rational(-1) * edge.along, edge.from - from, false);
      }
    }
    for (const auto& edge : part_.edges) {
      look_for_interrupt();
      for (const auto& vertex : obstacles_.vertices) {
        // from + t way + s e + u along = o, where u = s times how far along.
        meet(way, edge.from, edge.along, vertex.at - from, true);
      }
    }
  }

  /// t way + s scaled + u along = target with 0 <= t <= 1, s > 0 and 0 <= u <= 1, or <= s.
  void meet(const SpacePoint& way, const SpacePoint& scaled, const SpacePoint& along,
            const SpacePoint& target, bool up_to_scale) {
    const SpacePoint across = cross(scaled, along);
    const Rational determinant = dot(way, across);
    if (determinant == 0) return meet_in_a_plane(way, scaled, along, target, up_to_scale);
    const Rational t = dot(target, across) / determinant;
    if (t < 0 || t > 1) return;
    const Rational s = dot(way, cross(target, along)) / determinant;
    const Rational u = dot(way, cross(scaled, target)) / determinant;
    if (u >= 0 && u <= (up_to_scale ? s : Rational(1))) add(s);
  }

  void meet_in_a_plane(const SpacePoint& way, const SpacePoint& scaled, const SpacePoint& along,
                       const SpacePoint& target, bool up_to_scale) {
    std::vector<StripCondition> conditions;
    const auto below = [&](const SpacePoint& n, const Rational& least, const Rational& per_scale) {
      // n · (t way + s scaled - target) + least + s per_scale <= 0
      conditions.push_back({dot(n, way), dot(n, scaled) + per_scale, least - dot(n, target)});
    };
    const SpacePoint axis = along.x != 0   ? SpacePoint{0, 1, 0}
                            : along.y != 0 ? SpacePoint{0, 0, 1}
                                           : SpacePoint{1, 0, 0};
    const SpacePoint first = cross(along, axis);
    for (const SpacePoint& n : {first, cross(along, first)}) {
      below(n, 0, 0);
      below(Rational(-1) * n, 0, 0);
    }
    // u |along|² = along · (target - t way - s scaled) lies from 0 to |along|², or s of it.
    const Rational length = dot(along, along);
    below(along, 0, 0);
    below(Rational(-1) * along, up_to_scale ? Rational(0) : Rational(-length),
          up_to_scale ? Rational(-length) : Rational(0));
    const auto polygon = strip_polygon(conditions, false, is_zero(way));
    if (!polygon) return;
    for (const StripPoint& corner : polygon->corners) add(corner.s);
  }

  void at_vertex(const SpacePoint& x) {
    for (const auto& triangle : obstacles_.triangles) {
      look_for_interrupt();
      for (const auto& vertex : part_.vertices) {
        if (!are_all(vertex.leaving, triangle.normal, 1)) continue;
        const Rational rise = dot(triangle.normal, vertex.at);
        if (rise == 0) continue;
        const Rational s = dot(triangle.normal, triangle.corners[0] - x) / rise;
        if (s > 0 && is_in(triangle, x + s * vertex.at)) add(s);
      }
    }
    for (const auto& triangle : part_.triangles) {
      look_for_interrupt();
      const Rational rise = dot(triangle.normal, triangle.corners[0]);
      if (rise == 0) continue;
      for (const auto& vertex : obstacles_.vertices) {
        if (!are_all(vertex.leaving, triangle.normal, 1)) continue;
        const Rational s = dot(triangle.normal, vertex.at - x) / rise;
        if (s > 0 && is_in(triangle, 1 / s * (vertex.at - x))) add(s);
      }
    }
    for (const auto& edge : obstacles_.edges) {
      look_for_interrupt();
      for (const auto& other : part_.edges) cross_at(x, edge, other);
    }
  }

  void cross_at(const SpacePoint& x, const TouchingParts::Edge& edge,
                const TouchingParts::Edge& of_robot) {
    const SpacePoint n = cross(edge.along, of_robot.along);
    const Rational rise = dot(n, of_robot.from);
    if (rise == 0) return;  // also of parallel edges
    const auto apart = [&](int side) {
      return are_all(edge.into_faces, n, -side) && are_all(of_robot.into_faces, n, side);
    };
    if (!apart(1) && !apart(-1)) return;
    const Rational s = dot(n, edge.from - x) / rise;
    if (s <= 0) return;
    // e + u along = x + s (r + v along of the part).
    const SpacePoint between = x + s * of_robot.from - edge.from;
    const Rational size = dot(n, n);
    const Rational u = dot(cross(between, of_robot.along), n) / size;
    const Rational v = dot(cross(between, edge.along), n) / size;
    if (u >= 0 && u <= 1 && v >= 0 && v <= s) add(s);
  }

  TouchingParts part_, obstacles_;
  const std::vector<SpacePoint>& path_;
  std::vector<Rational> scales_;
};

}  // namespace

std::vector<Rational> contact_scales(const Polyhedron& part, const Polyhedron& obstacles,
                                     const std::vector<SpacePoint>& path) {
  return ContactScales(part, obstacles, path).run();
}

}  // namespace minkref::inline space
