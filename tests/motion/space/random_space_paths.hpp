// Random polyhedra and paths in space, many of them degenerate; prisms over polygons.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <tuple>

#include "reference/motion/space/valid_scales.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "tests/motion/random_paths.hpp"
#include "tests/space/sums/polycubes.hpp"
#include "tests/space/surfaces.hpp"

namespace minkref::testing {

using SpacePath = std::vector<SpacePoint>;

struct SpaceCase {
  Polyhedron part, obstacles;
  SpacePath path;
};

inline int below_in(std::mt19937& dice, int count) {
  return std::uniform_int_distribution<int>(0, count - 1)(dice);
}
inline int between_in(std::mt19937& dice, int least, int most) {
  return std::uniform_int_distribution<int>(least, most)(dice);
}
inline SpacePoint drawn_point(std::mt19937& dice, int size) {
  return {between_in(dice, -size, size), between_in(dice, -size, size),
          between_in(dice, -size, size)};
}

/// Convex, of cells under a matrix, a box with a dent, or two apart.
inline Polyhedron drawn_solid(std::mt19937& dice) {
  switch (below_in(dice, 4)) {
    case 0:
      return bodies::random_tetrahedron(dice, 3);
    case 1:
      for (;;) {
        const Polyhedron body = polycubes::solid(polycubes::random_cells(dice, 3, 2),
                                                 polycubes::random_matrix(dice, 2));
        if (polycubes::is_valid(body)) return body;
      }
    case 2:
      return translated(bodies::box(between_in(dice, 1, 3), 1, between_in(dice, 1, 3)),
                        drawn_point(dice, 2));
    default:
      return surfaces::together(
          {bodies::random_tetrahedron(dice, 2),
           translated(bodies::box(1, 2, 1), {between_in(dice, 3, 5), between_in(dice, -2, 2), 0})});
  }
}

/// A point, a segment, or a plane polygon.
inline Polyhedron drawn_thin(std::mt19937& dice) {
  const SpacePoint a = drawn_point(dice, 2),
                   way{between_in(dice, 1, 3), between_in(dice, -2, 2), between_in(dice, -2, 2)};
  const SpacePoint b{a.x + way.x, a.y + way.y, a.z + way.z};
  switch (below_in(dice, 3)) {
    case 0:
      return {{a}, {}};
    case 1:
      return {{a, b}, {}};
    default:
      return {{a, b, {b.x, b.y + 1, b.z + 2}, {(a.x + b.x) / 2, a.y, a.z + 3}}, {{0, 1, 2}}};
  }
}

/// One vertex to four, on a grid, on corners of contact positions (o - s r), or along an edge of
/// the obstacles; some closed, some with a vertex twice in a row.
inline SpacePath drawn_path(std::mt19937& dice, const Polyhedron& part,
                            const Polyhedron& obstacles) {
  const std::vector<SpacePoint>&r = part.vertices, &o = obstacles.vertices;
  const auto any = [&](const std::vector<SpacePoint>& all) -> const SpacePoint& {
    return all[static_cast<std::size_t>(below_in(dice, static_cast<int>(all.size())))];
  };
  const Rational scales[] = {1, 2, Rational(1, 2), Rational(3, 2), Rational(1, 3)};
  const Rational s = scales[below_in(dice, 5)];
  const auto position = [&]() -> SpacePoint {
    if (below_in(dice, 3) != 0) {
      const SpacePoint p = drawn_point(dice, 8);
      const Rational half(1, below_in(dice, 2) + 1);
      return {p.x * half, p.y * half, p.z * half};
    }
    const SpacePoint &a = any(r), &b = any(o);
    return {b.x - s * a.x, b.y - s * a.y, b.z - s * a.z};
  };
  SpacePath path{position()};
  for (int more = below_in(dice, 4); more > 0; --more) {
    if (below_in(dice, 3) == 0) {
      const SpacePoint &a = any(o), &b = any(o), &at = path.back();
      path.push_back({at.x + b.x - a.x, at.y + b.y - a.y, at.z + b.z - a.z});
    } else {
      path.push_back(position());
    }
  }
  if (below_in(dice, 6) == 0) path.push_back(path.front());
  if (below_in(dice, 10) == 0) path.push_back(path.back());
  return path;
}

/// A polygon set times the heights from low to high; none where its rings touch.
inline std::optional<Polyhedron> prism(const PolygonSet& set, const Rational& low,
                                       const Rational& high) {
  Polyhedron result;
  const auto less = [](const Point& a, const Point& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  };
  std::map<Point, std::uint32_t, decltype(less)> numbers(less);  // of the lower vertices
  const auto add = [&](const Point& p) {
    if (!numbers.try_emplace(p, static_cast<std::uint32_t>(result.vertices.size())).second) {
      return false;
    }
    result.vertices.push_back({p.x, p.y, low});
    result.vertices.push_back({p.x, p.y, high});
    return true;
  };
  if (set.is_point()) {
    add(set.polygons[0].outer[0]);
    return result;
  }
  if (set.is_segment()) {
    for (const Point& p : set.polygons[0].outer) add(p);
    result.faces = {{0, 2, 3, 1}};
    return result;
  }
  for (const Polygon& polygon : set.polygons) {
    std::vector<Ring> rings{polygon.outer};
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    for (const Ring& ring : rings) {
      for (const Point& p : ring) {
        if (!add(p)) return std::nullopt;
      }
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t a = numbers[ring[k]], b = numbers[ring[(k + 1) % ring.size()]];
        result.faces.push_back({a, b, b + 1, a + 1});
      }
    }
  }
  for (const Triangle& t : triangulate(set)) {
    const std::uint32_t a = numbers[t[0]], b = numbers[t[1]], c = numbers[t[2]];
    result.faces.push_back({c, b, a});
    result.faces.push_back({a + 1, b + 1, c + 1});
  }
  return result;
}

inline std::string text(const Polyhedron& body) {
  std::string all = "vertices";
  for (const SpacePoint& v : body.vertices) {
    all += " (" + to_string(v.x) + ", " + to_string(v.y) + ", " + to_string(v.z) + ")";
  }
  all += " faces";
  for (const Face& face : body.faces) {
    all += " [";
    for (const std::uint32_t v : face) all += (all.back() == '[' ? "" : ", ") + std::to_string(v);
    all += "]";
  }
  return all;
}

inline std::string text(const SpaceCase& c) {
  return "part " + text(c.part) + "\nobstacles " + text(c.obstacles) + "\npath " +
         text(Polyhedron{c.path, {}});
}

}  // namespace minkref::testing
