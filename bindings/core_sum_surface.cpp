// The boundary of a polyhedral set: its faces, meshes, parents, and topology.
#include "bindings/core_sum_surface.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/space/surface/manifold_mesh.hpp"
#include "reference/space/surface/mesh_of.hpp"
#include "reference/space/surface/parent_faces.hpp"
#include "reference/space/surface/shells.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// A facet's plane; its rings, the outer ring first; and the points where tips touch the facet.
using FacetRow = std::tuple<std::uint32_t, std::vector<Face>, std::vector<std::uint32_t>>;
using ParentRow = std::pair<Face, Face>;

template <class Row>
std::vector<Row> points_of(const SurfaceEdges& surface, Row (*row)(const SpacePoint&)) {
  std::vector<Row> result;
  result.reserve(surface.points.size());
  for (const SpaceVertex& point : surface.points) result.push_back(row(point.exact));
  return result;
}

std::vector<FacetRow> facets_of(const SurfaceEdges& surface) {
  std::vector<FacetRow> result;
  for (const SurfaceFace& face : surface.faces) {
    std::vector<Face> rings;
    for (const std::uint32_t first : face.walks) {
      Face& ring = rings.emplace_back();
      for (const std::uint32_t h : surface.walk(first)) ring.push_back(surface.half_edges[h].from);
    }
    result.emplace_back(face.plane, std::move(rings), face.tips);
  }
  return result;
}

std::size_t edges_of(const SurfaceEdges& surface) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const HalfEdge& half : surface.half_edges) {
    edges.emplace(std::min(half.from, half.to), std::max(half.from, half.to));
  }
  return edges.size();
}

std::vector<std::vector<ParentRow>> parents_of(const SurfaceEdges& surface, const Surface& P,
                                               const Surface& Q, const ExactSpacePoint& scaling) {
  std::vector<std::vector<ParentRow>> result;
  for (const auto& pairs : parent_faces(surface, P.value(), Q.value(), to_scaling(scaling))) {
    std::vector<ParentRow>& rows = result.emplace_back();
    for (const auto& [p, q] : pairs) rows.emplace_back(p, q);
  }
  return result;
}

}  // namespace

void bind_sum_surface(nb::module_& module) {
  unchanging(nb::class_<SumSurface>(
                 module, "SumSurface",
                 "The boundary of a PolyhedralSet, exact: facets, each a connected part of the "
                 "boundary in one plane, with edges that conform and common vertices."))
      .def("__repr__",
           [](const SumSurface& self) {
             return "<SumSurface: " + std::to_string(self.value->points.size()) + " vertices, " +
                    std::to_string(self.value->faces.size()) + " facets>";
           })
      .def_prop_ro("vertices", [](const SumSurface& self) { return self.value->points.size(); })
      .def_prop_ro(
          "edges", [](const SumSurface& self) { return edges_of(*self.value); }, Released())
      .def_prop_ro("facets", [](const SumSurface& self) { return self.value->faces.size(); })
      .def(
          "points", [](const SumSurface& self) { return points_of(*self.value, exact_point); },
          Released(), "The vertices, exact, in lexicographic order: triples of Fractions.")
      .def(
          "written_points",
          [](const SumSurface& self) {
            return points_of<ExactSpacePoint>(*self.value, to_strings);
          },
          Released(), "The same as documents have them: texts of exact numbers.")
      .def(
          "rings", [](const SumSurface& self) { return facets_of(*self.value); }, Released(),
          "Of each facet the number of its plane in the canonical form; its rings of vertices, "
          "counter-clockwise seen from outside, the outer one first, then those around holes, and "
          "those there and back along edges in its inside; the vertices at which tips touch it.")
      .def(
          "triangles",
          [](const SumSurface& self) { return mesh_faces(*self.value, MeshFaces::triangles); },
          Released(), "Of each facet the triangles into which it is cut.")
      .def(
          "mesh",
          [](const SumSurface& self, bool triangles) {
            return Surface(triangles ? manifold_mesh(*self.value) : mesh_of(*self.value));
          },
          "triangles"_a = false, Released(),
          "A closed mesh: faces are the facets that are simple polygons, and triangles of the "
          "others; where the set touches itself it is not manifold, and no operand. With "
          "`triangles`, a mesh of triangles that is closed and manifold by the numbers of its "
          "vertices: where the set touches itself, several vertices stand at one place.")
      .def(
          "topology",
          [](const SumSurface& self) {
            const SpaceTopology found = topology(*self.value);
            return std::tuple(found.components, found.cavities, found.tunnels);
          },
          Released(),
          "How many components the interior has, how many bounded ones the complement, and how "
          "many tunnels there are: the genera of the surfaces that bound the components, added up.")
      .def(
          "parents",
          [](const SumSurface& self, const Surface& P, const Surface& Q,
             const ExactSpacePoint& scaling) { return parents_of(*self.value, P, Q, scaling); },
          "P"_a, "Q"_a, "scaling"_a, Released(),
          "Of each facet of S P ⊕ Q the faces of P and Q, by their vertices, whose sums have area "
          "in common with it: a face and a vertex, a vertex and a face, or two edges. Exact.");
}

}  // namespace minkref::python
