#include "reference/space/surface/manifold_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/face_triangles.hpp"
#include "reference/space/surface/mesh_of.hpp"

namespace minkref::inline space {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

/// A triangle's side: 3 times the triangle's number, plus the place of the side's first corner.
using Side = std::uint32_t;
constexpr Side side_after(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }

/// Triangles, and for each side the matching side of the triangle beyond.
struct JoinedTriangles {
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> face;  ///< of each
  std::vector<Side> beyond;

  std::size_t sides() const { return 3 * corners.size(); }
  std::uint32_t from(Side side) const { return corners[side / 3][side % 3]; }
  std::uint32_t to(Side side) const { return from(side_after(side)); }
};

/// Finds sides by face and ends.
class SideNames {
 public:
  explicit SideNames(const JoinedTriangles& triangles) {
    for (Side s = 0; s < triangles.sides(); ++s) {
      look_for_interrupt();
      sides_.emplace_back(triangles.face[s / 3], triangles.from(s), triangles.to(s), s);
    }
    std::sort(sides_.begin(), sides_.end());
  }
  /// Returns `none` if no side has this name.
  Side named(std::uint32_t face, std::uint32_t from, std::uint32_t to) const {
    const auto found =
        std::lower_bound(sides_.begin(), sides_.end(), std::tuple(face, from, to, Side{0}));
    if (found == sides_.end()) return none;
    const auto& [own_face, own_from, own_to, side] = *found;
    return std::tuple(own_face, own_from, own_to) == std::tuple(face, from, to) ? side : none;
  }

 private:
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, Side>> sides_;
};

/// Gives each fan its own vertices: corners are the same iff a walk across sides connects them.
class Fans {
 public:
  explicit Fans(const JoinedTriangles& triangles) : parent_(triangles.sides()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (Side s = 0; s < triangles.sides(); ++s) {
      look_for_interrupt();
      join(s, side_after(triangles.beyond[s]));
      join(side_after(s), triangles.beyond[s]);
    }
  }
  std::uint32_t root(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }
  std::vector<std::uint32_t> parent_;
};

/// Middles for sides that share both ends with a side other than the side beyond.
class SideMiddles {
 public:
  SideMiddles(const JoinedTriangles& triangles, Polyhedron& mesh)
      : triangles_(triangles), middle_(triangles.sides(), none) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, Side>> runs;
    for (Side s = 0; s < triangles.sides(); ++s) {
      look_for_interrupt();
      runs.emplace_back(triangles.from(s), triangles.to(s), s);
    }
    std::sort(runs.begin(), runs.end());
    const auto same_run = [&](std::size_t a, std::size_t b) {
      return std::get<0>(runs[a]) == std::get<0>(runs[b]) &&
             std::get<1>(runs[a]) == std::get<1>(runs[b]);
    };
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const bool is_alone =
          (k == 0 || !same_run(k - 1, k)) && (k + 1 == runs.size() || !same_run(k, k + 1));
      if (!is_alone) cut(std::get<2>(runs[k]), mesh);
    }
  }

  /// Appends the triangle, split as the middles require.
  void append(std::uint32_t triangle, std::vector<Face>& faces) const {
    Face ring;
    std::size_t start = 0, middles = 0;
    for (Side s = 3 * triangle; s < 3 * triangle + 3; ++s) {
      ring.push_back(triangles_.from(s));
      if (middle_[s] == none) continue;
      ++middles;
      ring.push_back(middle_[s]);
    }
    if (middles == 3) {
      for (const std::size_t k : {0U, 2U, 4U})
        faces.push_back({ring[(k + 5) % 6], ring[k], ring[k + 1]});
      faces.push_back({ring[1], ring[3], ring[5]});
      return;
    }
    // Starts at the corner opposite the only middle, or at the end of the side without a middle.
    for (Side s = 3 * triangle; s < 3 * triangle + 3; ++s) {
      const bool here = middle_[s] == none, next = middle_[side_after(s)] == none;
      if (middles == 1 && here && !next) start = index_of(ring, triangles_.from(s));
      if (middles == 2 && here) start = index_of(ring, triangles_.to(s));
    }
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
    if (middles == 2) {  // a, middle, b, middle, c
      faces.push_back({ring[1], ring[2], ring[3]});
      ring.erase(ring.begin() + 2);
    }
    for (std::size_t k = 2; k < ring.size(); ++k) faces.push_back({ring[0], ring[k - 1], ring[k]});
  }

 private:
  static std::size_t index_of(const Face& ring, std::uint32_t vertex) {
    return static_cast<std::size_t>(std::find(ring.begin(), ring.end(), vertex) - ring.begin());
  }

  void cut(Side side, Polyhedron& mesh) {
    if (middle_[side] != none || triangles_.beyond[side] == none) return;
    const SpacePoint &p = mesh.vertices[triangles_.from(side)],
                     &q = mesh.vertices[triangles_.to(side)];
    SpacePoint middle{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
    middle_[side] = middle_[triangles_.beyond[side]] =
        static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(std::move(middle));
  }

  const JoinedTriangles& triangles_;
  std::vector<std::uint32_t> middle_;
};

void append_triangles(const JoinedTriangles& triangles, Polyhedron& mesh) {
  const SideMiddles middles(triangles, mesh);
  for (std::uint32_t t = 0; t < triangles.corners.size(); ++t) middles.append(t, mesh.faces);
}

}  // namespace

Polyhedron manifold_mesh(const SurfaceEdges& surface) {
  JoinedTriangles triangles;
  const std::vector<std::vector<Face>> cut = mesh_faces(surface, MeshFaces::triangles);
  for (std::uint32_t f = 0; f < cut.size(); ++f) {
    for (const Face& t : cut[f]) {
      triangles.corners.push_back({t[0], t[1], t[2]});
      triangles.face.push_back(f);
    }
  }
  const SideNames names(triangles);
  triangles.beyond.resize(triangles.sides());
  for (Side s = 0; s < triangles.sides(); ++s) {  // of diagonals
    triangles.beyond[s] = names.named(triangles.face[s / 3], triangles.to(s), triangles.from(s));
  }
  for (const HalfEdge& half : surface.half_edges) {
    look_for_interrupt();
    const HalfEdge& mate = surface.half_edges[half.mate(Pairing::interior)];
    triangles.beyond[names.named(half.face, half.from, half.to)] =
        names.named(mate.face, mate.from, mate.to);
  }
  Fans fans(triangles);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> vertices;  // point, root
  for (std::uint32_t c = 0; c < triangles.sides(); ++c) {
    if (fans.root(c) == c) vertices.emplace_back(triangles.from(c), c);
  }
  std::sort(vertices.begin(), vertices.end());
  Polyhedron mesh;
  std::vector<std::uint32_t> number(triangles.sides());
  for (const auto& [point, root] : vertices) {
    number[root] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(surface.points[point].exact);
  }
  for (Side c = 0; c < triangles.sides(); ++c) {
    triangles.corners[c / 3][c % 3] = number[fans.root(c)];
  }
  append_triangles(triangles, mesh);
  return mesh;
}

Polyhedron cut_into_triangles(const Polyhedron& polyhedron) {
  if (polyhedron.faces.empty()) return polyhedron;
  validate_faces(polyhedron);
  const IntegerPoints whole = integer_points(polyhedron.vertices);
  const VertexSigns signs(whole.points);
  JoinedTriangles triangles;
  for (std::uint32_t f = 0; f < polyhedron.faces.size(); ++f) {
    look_for_interrupt();
    const auto cut = face_triangles(polyhedron.faces[f], signs);
    if (!cut) {
      Place place;
      place.face = f;
      throw BadInput("not-representable", "the face is not planar and simple",
                     "cut the face into triangles", place);
    }
    for (const TriangleCorners& t : *cut) {
      triangles.corners.push_back(t);
      triangles.face.push_back(f);
    }
  }
  const SideNames names(triangles);
  triangles.beyond.resize(triangles.sides());
  for (Side s = 0; s < triangles.sides(); ++s) {  // none beyond edges: these stay as they are
    triangles.beyond[s] = names.named(triangles.face[s / 3], triangles.to(s), triangles.from(s));
  }
  Polyhedron mesh{polyhedron.vertices, {}};
  append_triangles(triangles, mesh);
  return mesh;
}

}  // namespace minkref::inline space
