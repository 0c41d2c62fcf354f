#include "reference/space/surface/shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reference/space/surface/mesh_of.hpp"
#include "reference/space/surface/projected_areas.hpp"
#include "tests/space/surface/tetrahedra.hpp"

namespace minkref::of_shells {
namespace {

using surface_test::CellCount;
using surface_test::TetrahedraGrid;
using LinearMap = std::array<std::array<Rational, 3>, 3>;

LinearMap straight() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }
/// No plane of the grid stays at right angles to an axis; the determinant is positive.
LinearMap slanted() {
  return {{{1, Rational(1, 3), Rational(-1, 5)},
           {Rational(-1, 7), 1, Rational(2, 5)},
           {Rational(1, 9), Rational(-1, 2), 1}}};
}
Rational determinant(const LinearMap& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

using Boxes = std::vector<std::array<int, 3>>;

PolyhedralSet cubes(const Boxes& full, const LinearMap& map, int n = 7) {
  TetrahedraGrid grid(n);
  for (const auto& [x, y, z] : full) grid.fill_cube(x, y, z);
  return polyhedral_set(grid.soup(map));
}

Boxes block(int x, int y, int z) {
  Boxes result;
  for (int i = 1; i <= x; ++i) {
    for (int j = 1; j <= y; ++j) {
      for (int k = 1; k <= z; ++k) result.push_back({i, j, k});
    }
  }
  return result;
}
Boxes without(Boxes boxes, const Boxes& gone) {
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(),
                             [&](const auto& b) {
                               return std::find(gone.begin(), gone.end(), b) != gone.end();
                             }),
              boxes.end());
  return boxes;
}

void expect_closed(const Polyhedron& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t a = face[k], b = face[(k + 1) % face.size()];
      ASSERT_NE(a, b);
      runs[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, balance] : runs) EXPECT_EQ(balance, 0);
}

/// Checks that no vertex lies inside an edge.
void expect_conforming(const Polyhedron& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
    }
  }
  for (const auto& [a, b] : edges) {
    const RationalVector d = mesh.vertices[b] - mesh.vertices[a];
    for (const SpacePoint& p : mesh.vertices) {
      const RationalVector w = p - mesh.vertices[a];
      const RationalVector c = cross(d, w);
      if (!c[0].is_zero() || !c[1].is_zero() || !c[2].is_zero()) continue;
      const Rational along = dot(d, w);
      EXPECT_FALSE(along > 0 && along < dot(d, d));
    }
  }
}

/// The meshes bound the same set, as does the sum of its shells.
void expect_consistent(const PolyhedralSet& set) {
  const SurfaceEdges surface = surface_edges(set);
  for (const MeshFaces kind : {MeshFaces::polygons, MeshFaces::triangles}) {
    const Polyhedron mesh = mesh_of(surface, kind);
    expect_closed(mesh);
    EXPECT_EQ(sextuple_volume(mesh), volume(set) * 6);
    EXPECT_EQ(polyhedral_set(mesh), set);
    expect_conforming(mesh);
    for (const Face& face : mesh.faces) {
      EXPECT_TRUE(kind == MeshFaces::polygons || face.size() == 3);
      EXPECT_EQ(std::set(face.begin(), face.end()).size(), face.size());
    }
  }
  for (const Pairing pairing : {Pairing::interior, Pairing::outside}) {
    Rational sum = 0;
    for (const Shell& shell : shells(surface, pairing)) {
      const Rational part = volume(surface, shell);
      EXPECT_EQ(sign(part), shell.positive ? 1 : -1);
      sum += part;
    }
    EXPECT_EQ(sum, volume(set));
  }
}

void expect_topology(const PolyhedralSet& set, const SpaceTopology& expected) {
  const SpaceTopology found = topology(surface_edges(set));
  EXPECT_EQ(found.components, expected.components);
  EXPECT_EQ(found.cavities, expected.cavities);
  EXPECT_EQ(found.tunnels, expected.tunnels);
  expect_consistent(set);
}

void expect_cubes(const Boxes& boxes, const SpaceTopology& expected) {
  for (const LinearMap& map : {straight(), slanted()}) {
    const PolyhedralSet set = cubes(boxes, map);
    EXPECT_EQ(volume(set), determinant(map) * static_cast<long>(boxes.size()));
    expect_topology(set, expected);
  }
}

TEST(Shells, KnownSetsOfCubes) {
  expect_cubes({}, {0, 0, 0});
  expect_cubes(block(1, 1, 1), {1, 0, 0});
  expect_cubes(without(block(3, 3, 1), {{2, 2, 1}}), {1, 0, 1});
  expect_cubes(without(block(5, 3, 1), {{2, 2, 1}, {4, 2, 1}}), {1, 0, 2});
  expect_cubes({{1, 1, 1}, {3, 3, 3}}, {2, 0, 0});
  expect_cubes(without(block(3, 3, 3), {{2, 2, 2}}), {1, 1, 0});
  // The frame of a cube: twelve edges, eight corners.
  expect_cubes(
      without(block(3, 3, 3),
              {{2, 2, 2}, {1, 2, 2}, {3, 2, 2}, {2, 1, 2}, {2, 3, 2}, {2, 2, 1}, {2, 2, 3}}),
      {1, 0, 5});
}

TEST(Shells, CubesThatTouch) {
  expect_cubes({{1, 1, 1}, {2, 2, 1}}, {2, 0, 0});
  expect_cubes({{1, 1, 1}, {2, 2, 2}}, {2, 0, 0});
  // A chain that closes at an edge: no tunnel, since the interior does not close.
  expect_cubes(without(block(3, 3, 1), {{2, 2, 1}, {1, 1, 1}}), {1, 0, 0});
  // Two cavities, pinched along an edge or at a vertex; both interiors are connected.
  expect_cubes(without(block(4, 4, 3), {{2, 2, 2}, {3, 3, 2}}), {1, 2, 0});
  expect_cubes(without(block(4, 4, 4), {{2, 2, 2}, {3, 3, 3}}), {1, 2, 0});
  // A cavity that reaches an outside edge.
  expect_cubes(without(block(3, 3, 3), {{2, 2, 2}, {1, 1, 2}}), {1, 1, 0});
  // A cube inside a cavity.
  Boxes nested = block(5, 5, 5);
  for (const auto& b : block(3, 3, 3)) nested = without(nested, {{b[0] + 1, b[1] + 1, b[2] + 1}});
  nested.push_back({3, 3, 3});
  expect_cubes(nested, {2, 1, 0});
}

/// The faces of boxes and prisms, unjoined.
class Soup {
 public:
  void add(const std::vector<std::array<int, 3>>& face) {
    Face corners;
    for (const auto& [x, y, z] : face) {
      corners.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
      mesh_.vertices.push_back({x, y, z});
    }
    mesh_.faces.push_back(corners);
  }
  /// A prism along x over a ring of (y, z), counter-clockwise seen from large x.
  void add_prism(int x0, int x1, const std::vector<std::array<int, 2>>& ring, bool ends = true) {
    std::vector<std::array<int, 3>> low, high;
    for (const auto& [y, z] : ring) high.push_back({x1, y, z}), low.push_back({x0, y, z});
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::size_t n = (k + 1) % ring.size();
      add({low[k], low[n], high[n], high[k]});
    }
    std::reverse(low.begin(), low.end());
    if (ends) add(high), add(low);
  }
  PolyhedralSet set() const { return polyhedral_set(mesh_); }

 private:
  Polyhedron mesh_;
};

std::size_t slit_edges(const PolyhedralSet& set) {
  std::size_t count = 0;
  for (const auto& list : conforming_edges(set).slits) count += list.size();
  return count;
}

const std::vector<std::array<int, 2>> slab{{0, 0}, {4, 0}, {4, 1}, {0, 1}};

TEST(Shells, WedgesThatStandOnAPlane) {
  const std::vector<std::array<int, 2>> wedge{{2, 1}, {3, 2}, {1, 2}};
  Soup within, flush, jutting;
  for (Soup* soup : {&within, &flush, &jutting}) soup->add_prism(0, 4, slab);
  within.add_prism(1, 3, wedge);
  flush.add_prism(0, 4, wedge);
  jutting.add_prism(1, 9, wedge);
  EXPECT_EQ(slit_edges(within.set()), 1U);
  EXPECT_EQ(slit_edges(flush.set()), 1U);
  EXPECT_EQ(slit_edges(jutting.set()), 1U);
  for (const Soup* soup : {&within, &flush, &jutting}) {
    expect_topology(soup->set(), {2, 0, 0});
    EXPECT_EQ(shells(surface_edges(soup->set()), Pairing::interior).size(), 2U);
  }
  // From the outside one surface, cut along the slit: open at its ends or not.
  EXPECT_EQ(shells(surface_edges(within.set()), Pairing::outside).size(), 1U);
  EXPECT_EQ(shells(surface_edges(flush.set()), Pairing::outside).size(), 1U);
  // No region has a vertex where the slab's border crosses the wedge's edge.
  const auto points = surface_edges(jutting.set()).points;
  EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                          [](const SpaceVertex& v) { return v.exact == SpacePoint{4, 2, 1}; }));
}

TEST(Shells, ATipOnAPlane) {
  Soup soup;
  soup.add_prism(0, 4, slab);
  // A pyramid upside down, between faces that would be polygons otherwise.
  soup.add({{1, 1, 3}, {3, 1, 3}, {3, 3, 3}, {1, 3, 3}});
  soup.add({{2, 2, 1}, {3, 1, 3}, {1, 1, 3}});
  soup.add({{2, 2, 1}, {3, 3, 3}, {3, 1, 3}});
  soup.add({{2, 2, 1}, {1, 3, 3}, {3, 3, 3}});
  soup.add({{2, 2, 1}, {1, 1, 3}, {1, 3, 3}});
  expect_topology(soup.set(), {2, 0, 0});
  std::size_t tips = 0;
  for (const SurfaceFace& face : surface_edges(soup.set()).faces) tips += face.tips.size();
  EXPECT_EQ(tips, 1U);
  EXPECT_EQ(mesh_of(surface_edges(soup.set())).faces.size(), 5U + 5U + 4U);
}

TEST(Shells, TunnelsThatTouchTheOuterFaceAlongALine) {
  Soup open, closed;
  const std::vector<std::array<int, 2>> hollow{{2, 4}, {1, 3}, {2, 2}, {3, 3}};
  const std::vector<std::array<int, 2>> around{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto reversed = [](auto ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
  };
  open.add_prism(0, 5, around, false);
  open.add_prism(0, 5, reversed(hollow), false);
  open.add({{5, 0, 0},
            {5, 4, 0},
            {5, 4, 4},
            {5, 2, 4},
            {5, 3, 3},
            {5, 2, 2},
            {5, 1, 3},
            {5, 2, 4},
            {5, 0, 4}});
  open.add({{0, 0, 4},
            {0, 2, 4},
            {0, 1, 3},
            {0, 2, 2},
            {0, 3, 3},
            {0, 2, 4},
            {0, 4, 4},
            {0, 4, 0},
            {0, 0, 0}});
  EXPECT_EQ(volume(open.set()), 5 * 14);
  expect_topology(open.set(), {1, 0, 0});
  closed.add_prism(0, 5, around);
  closed.add_prism(1, 4, reversed(hollow));
  EXPECT_EQ(volume(closed.set()), 5 * 16 - 3 * 2);
  expect_topology(closed.set(), {1, 1, 0});
  EXPECT_EQ(slit_edges(closed.set()), 1U);
}

TEST(Shells, ThreePlanesThatCrossInALineWithoutABorder) {
  // About a cube's diagonal, three of six tetrahedra, alternating.
  for (const LinearMap& map : {straight(), slanted()}) {
    TetrahedraGrid grid(3);
    std::size_t filled = 0;
    for (std::size_t c = 13 * 6; c < 14 * 6; ++c) {
      grid.full[c] = TetrahedraGrid::is_even(c);
      filled += grid.full[c];
    }
    EXPECT_EQ(filled, 3U);
    expect_topology(polyhedral_set(grid.soup(map)), {3, 0, 0});
  }
}

TEST(Shells, FacesThatMissAreFound) {
  PolyhedralSet set = cubes(block(2, 1, 1), slanted());
  set.faces.erase(set.faces.begin() + 2);
  EXPECT_THROW(surface_edges(set), std::logic_error);
  set = cubes(block(2, 1, 1), straight());
  set.faces[0].plane.normal[0] = -set.faces[0].plane.normal[0];
  set.faces[0].plane.offset = -set.faces[0].plane.offset;
  EXPECT_THROW(surface_edges(set), std::logic_error);
}

void expect_as_counted(const TetrahedraGrid& grid, const LinearMap& map) {
  const PolyhedralSet set = polyhedral_set(grid.soup(map));
  const auto filled = std::count(grid.full.begin(), grid.full.end(), true);
  EXPECT_EQ(volume(set) * 6, determinant(map) * filled);
  const SurfaceEdges surface = surface_edges(set);
  for (const Pairing pairing : {Pairing::interior, Pairing::outside}) {
    const bool inside = pairing == Pairing::interior;
    const CellCount counted = count_cells(grid, inside);
    const std::vector<Shell> found = shells(surface, pairing);
    EXPECT_EQ(found.size(), counted.shells);
    long characteristic = 0;
    std::size_t borders = 0;
    for (const Shell& shell : found) {
      characteristic += shell.characteristic;
      borders += shell.positive == inside;
    }
    EXPECT_EQ(characteristic, counted.characteristic);
    EXPECT_EQ(borders, counted.components - (inside ? 0 : 1));
  }
  expect_consistent(set);
}

TEST(Shells, RandomTetrahedraAsCountedCellByCell) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::size_t with_slits = 0;
  for (int round = 0; round < 24; ++round) {
    TetrahedraGrid grid(round % 2 == 0 ? 4 : 5);
    std::bernoulli_distribution filled(0.1 + 0.8 * (round % 8) / 7);
    for (std::size_t c = 0; c < grid.cells.size(); ++c) {
      grid.full[c] = !grid.at_rim(c) && filled(random);
    }
    const LinearMap map = round % 3 == 0 ? slanted() : straight();
    expect_as_counted(grid, map);
    with_slits += slit_edges(polyhedral_set(grid.soup(map))) > 0;
  }
  EXPECT_GT(with_slits, 5U);
}

TEST(Shells, RandomCubesAsCountedCellByCell) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 16; ++round) {
    TetrahedraGrid grid(6);
    std::bernoulli_distribution filled(0.3 + 0.15 * (round % 4));
    for (std::size_t c = 0; c < grid.cells.size(); c += 6) {
      const auto at = static_cast<int>(c / 6);
      if (!grid.at_rim(c) && filled(random)) grid.fill_cube(at % 6, at / 6 % 6, at / 36);
    }
    expect_as_counted(grid, round % 2 == 0 ? slanted() : straight());
  }
}

TEST(ProjectedAreas, OfABoxAndOfASlantedOne) {
  EXPECT_EQ(projected_areas(cubes(block(2, 3, 4), straight())),
            (std::array<Rational, 3>{24, 16, 12}));
  // Two faces of each kind, with the map's cofactors as normals.
  const LinearMap m = slanted();
  std::array<Rational, 3> expected{0, 0, 0};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t i = (c + 1) % 3, j = (c + 2) % 3;
    const RationalVector normal =
        cross(RationalVector{m[0][i], m[1][i], m[2][i]}, RationalVector{m[0][j], m[1][j], m[2][j]});
    for (std::size_t k = 0; k < 3; ++k) expected[k] += 2 * Rational(abs(normal[k]));
  }
  EXPECT_EQ(projected_areas(cubes(block(1, 1, 1), m)), expected);
}

}  // namespace
}  // namespace minkref::of_shells
