// Random polygon sets: pieces of triangulated grids (touching rings, holes, several components,
// straight vertices, parallel edges) and untangled random polygons with holes.
#pragma once

#include <array>
#include <map>
#include <numeric>
#include <stdexcept>

#include "reference/error.hpp"
#include "tests/number/random_numbers.hpp"
#include "tests/plane/ray_casting.hpp"

namespace minkref::testing {

inline bool is_valid(const PolygonSet& set) {
  try {
    validate(set);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

/// Counter-clockwise triangles that meet edge to edge.
struct Mesh {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The union of chosen triangles. The boundary walk follows each wedge of the interior and splits
/// at repeated vertices, so rings are simple and touch where the triangles do.
class MeshRegion {
 public:
  MeshRegion(const Mesh& mesh, const std::vector<bool>& chosen) : mesh_(mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!chosen[t]) continue;
      for (std::size_t i = 0; i < 3; ++i) owner_[{corner(t, i), corner(t, i + 1)}] = t;
    }
    component_.resize(mesh.triangles.size());
    std::iota(component_.begin(), component_.end(), std::size_t{0});
    for (const auto& [edge, t] : owner_) {
      const auto twin = owner_.find({edge.second, edge.first});
      if (twin != owner_.end()) component_[find(t)] = find(twin->second);
    }
  }

  PolygonSet rings() {
    std::map<std::size_t, Polygon> polygons;
    std::map<std::pair<std::size_t, std::size_t>, bool> done;
    for (const auto& [first, triangle] : owner_) {
      if (owner_.count({first.second, first.first}) != 0 || done[first]) continue;
      std::vector<std::size_t> walk;
      for (auto edge = first; !done[edge]; edge = next(edge)) {
        done[edge] = true;
        close_loops(walk, edge.first, polygons[find(triangle)]);
      }
      close_loops(walk, first.first, polygons[find(triangle)]);
    }
    PolygonSet set;
    for (auto& [name, polygon] : polygons) set.polygons.push_back(std::move(polygon));
    return set;
  }

 private:
  std::size_t corner(std::size_t triangle, std::size_t i) const {
    return mesh_.triangles[triangle][i % 3];
  }
  std::size_t find(std::size_t t) const {
    while (component_[t] != t) t = component_[t];
    return t;
  }
  /// The boundary edge that leaves the head of `edge` along the same interior wedge.
  std::pair<std::size_t, std::size_t> next(std::pair<std::size_t, std::size_t> edge) const {
    std::size_t triangle = owner_.at(edge);
    for (;;) {
      std::size_t i = 0;
      while (corner(triangle, i) != edge.second) ++i;
      const std::pair<std::size_t, std::size_t> leaving{edge.second, corner(triangle, i + 1)};
      const auto twin = owner_.find({leaving.second, leaving.first});
      if (twin == owner_.end()) return leaving;
      triangle = twin->second;
    }
  }
  void close_loops(std::vector<std::size_t>& walk, std::size_t v, Polygon& polygon) const {
    const auto start = std::find(walk.begin(), walk.end(), v);
    if (start != walk.end()) {
      Ring ring;
      for (auto i = start; i != walk.end(); ++i) ring.push_back(mesh_.points[*i]);
      walk.erase(start, walk.end());
      Rational doubled = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
      }
      if (sign(doubled) < 0) {
        polygon.holes.push_back(std::move(ring));
      } else {
        if (!polygon.outer.empty()) throw std::logic_error("a component with two outer rings");
        polygon.outer = std::move(ring);
      }
    }
    walk.push_back(v);
  }

  const Mesh& mesh_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner_;
  std::vector<std::size_t> component_;
};

enum class Grid { lattice, warped, jittered };

/// nx by ny cells, each cut into four triangles round an inner point.
inline Mesh random_mesh(Source& random, int nx, int ny, Grid style) {
  Mesh mesh;
  std::vector<int> xs{random.between(-6, 6)}, ys{random.between(-6, 6)};
  for (int i = 0; i < nx; ++i) {
    xs.push_back(xs.back() + (style == Grid::warped ? random.between(2, 7) : 2));
  }
  for (int j = 0; j < ny; ++j) {
    ys.push_back(ys.back() + (style == Grid::warped ? random.between(2, 7) : 2));
  }
  const int unit = style == Grid::jittered ? 4 : 1;
  const auto jitter = [&] { return style == Grid::jittered ? random.between(-1, 1) : 0; };
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      mesh.points.push_back({unit * xs[static_cast<std::size_t>(i)] + jitter(),
                             unit * ys[static_cast<std::size_t>(j)] + jitter()});
    }
  }
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const auto at = [&](int di, int dj) {
        return static_cast<std::size_t>((j + dj) * (nx + 1) + i + di);
      };
      const std::array<std::size_t, 4> corners{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const auto inner = [&](int low, int high) {
        return style == Grid::lattice ? low + 1 : random.between(low + 1, high - 1);
      };
      mesh.points.push_back(style == Grid::jittered
                                ? Point{4 * xs[a] + 4 + jitter(), 4 * ys[b] + 4 + jitter()}
                                : Point{inner(xs[a], xs[a + 1]), inner(ys[b], ys[b + 1])});
      for (std::size_t k = 0; k < 4; ++k) {
        mesh.triangles.push_back({corners[k], corners[(k + 1) % 4], mesh.points.size() - 1});
      }
    }
  }
  return mesh;
}

/// Chooses mostly whole cells, so that the sets are not all dust.
inline std::vector<bool> random_choice(Source& random, const Mesh& mesh) {
  std::vector<bool> chosen(mesh.triangles.size());
  const int density = random.between(25, 85);
  do {
    for (std::size_t cell = 0; cell < chosen.size() / 4; ++cell) {
      const bool whole = random.between(1, 100) <= 65;
      const bool taken = random.between(1, 100) <= density;
      for (std::size_t k = 0; k < 4; ++k) {
        chosen[4 * cell + k] = whole ? taken : random.between(1, 100) <= density;
      }
    }
  } while (std::find(chosen.begin(), chosen.end(), true) == chosen.end());
  return chosen;
}

inline bool is_straight(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  return sign(cross(ring[i] - ring[(i + n - 1) % n], ring[(i + 1) % n] - ring[i])) == 0;
}

/// Removes straight vertices, each with the given chance in percent.
inline void drop_straight_vertices(Source& random, PolygonSet& set, int percent) {
  const auto thin = [&](Ring& ring) {
    for (std::size_t i = 0; i < ring.size();) {
      if (is_straight(ring, i) && random.between(1, 100) <= percent) {
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  };
  for (Polygon& polygon : set.polygons) {
    thin(polygon.outer);
    for (Ring& hole : polygon.holes) thin(hole);
  }
}

inline PolygonSet random_mesh_region(Source& random, int most_cells = 3) {
  const Mesh mesh = random_mesh(random, random.between(1, most_cells),
                                random.between(1, most_cells), static_cast<Grid>(random.below(3)));
  const std::vector<bool> chosen = random_choice(random, mesh);
  PolygonSet set = MeshRegion(mesh, chosen).rings();
  drop_straight_vertices(random, set, random.between(0, 2) * 50);
  return set;
}

/// A simple polygon through random grid points: reversing the chain between crossing edges
/// uncrosses them and shortens the ring. Touching points make some rings fail; these are drawn
/// again.
inline PolygonSet random_simple_polygon(Source& random, int vertices, int size) {
  for (;;) {
    Ring ring;
    while (static_cast<int>(ring.size()) < vertices) {
      const Point p{random.between(0, size), random.between(0, size)};
      if (std::find(ring.begin(), ring.end(), p) == ring.end()) ring.push_back(p);
    }
    const auto crossing = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
      return sign(cross(b - a, c - a)) * sign(cross(b - a, d - a)) < 0 &&
             sign(cross(d - c, a - c)) * sign(cross(d - c, b - c)) < 0;
    };
    bool again = true;
    for (int pass = 0; again && pass < 200; ++pass) {
      again = false;
      for (std::size_t i = 0; i + 1 < ring.size() && !again; ++i) {
        for (std::size_t j = i + 2; j < ring.size() && !again; ++j) {
          if (crossing(ring[i], ring[i + 1], ring[j], ring[(j + 1) % ring.size()])) {
            std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
            again = true;
          }
        }
      }
    }
    PolygonSet set = region(std::move(ring));
    if (is_valid(set)) return set;
  }
}

/// Punches random triangular and quadrilateral holes; omits holes that do not fit.
inline void punch_holes(Source& random, PolygonSet& set, int attempts, int size) {
  for (int i = 0; i < attempts; ++i) {
    Ring hole;
    const int x = random.between(0, size), y = random.between(0, size), reach = size / 3 + 1;
    const int parts = random.between(1, 2);
    for (int k = random.between(3, 4); k > 0; --k) {
      hole.push_back({x + Rational(random.between(0, reach), parts),
                      y + Rational(random.between(0, reach), parts)});
    }
    PolygonSet with = set;
    with.polygons[random.below(with.polygons.size())].holes.push_back(std::move(hole));
    orient(with);
    if (is_valid(with)) set = std::move(with);
  }
}

inline Ring convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), less_xy);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= base + 2 &&
             sign(cross(hull.back() - hull[hull.size() - 2], p - hull.back())) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

inline PolygonSet random_convex_polygon(Source& random, int points = 7, int size = 9) {
  for (;;) {
    std::vector<Point> cloud;
    for (int i = 0; i < points; ++i) {
      cloud.push_back({random.between(-size, size), random.between(-size, size)});
    }
    Ring hull = convex_hull(cloud);
    if (hull.size() >= 3) return region(std::move(hull));
  }
}

/// A region of any kind above; about one region in eight has holes.
inline PolygonSet random_region(Source& random, int most_cells = 3) {
  switch (random.below(6)) {
    case 0:
      return random_convex_polygon(random, random.between(3, 7), random.between(2, 9));
    case 1:
    case 2: {
      const int size = random.between(4, 12);
      PolygonSet set = random_simple_polygon(random, random.between(3, 4 * most_cells), size);
      if (random.below(3) != 0) punch_holes(random, set, 25, size);
      return set;
    }
    default:
      return random_mesh_region(random, most_cells);
  }
}

/// Moves each vertex by at most 2 units of 2^-bits; rings that share a vertex keep it.
inline PolygonSet shaken(Source& random, const PolygonSet& set, int bits) {
  const Rational unit(Integer(1), Integer(1) << bits);
  const int a = random.between(1, 97), b = random.between(1, 97);
  return mapped(set, [&](const Point& p) {
    const Rational hash = a * p.x + b * p.y;
    const int code = Integer(numerator(hash) % 25).convert_to<int>();
    return Point{Rational(p.x + unit * (code / 5 - 2)), Rational(p.y + unit * (code % 5 - 2))};
  });
}

}  // namespace minkref::testing
