#include "bindings/core_space_surface.hpp"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <string>
#include <tuple>
#include <utility>

#include "bindings/core_fields.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/space/surface/manifold_mesh.hpp"
#include "reference/space/surface/mesh_of.hpp"
#include "reference/space/surface/projected_areas.hpp"
#include "reference/space/surface/rounded_mesh.hpp"
#include "reference/space/surface/shells.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// The value that belongs to a name, from two choices.
template <class Value>
Value one_of(const std::string& name, const char* code, std::pair<const char*, Value> first,
             std::pair<const char*, Value> second) {
  for (const auto& [word, value] : {first, second}) {
    if (name == word) return value;
  }
  const std::string words = std::string(first.first) + " or " + second.first;
  throw BadInput(code, "no such choice: " + name, "give " + words);
}

Pairing pairing_named(const std::string& name) {
  return one_of<Pairing>(name, "unknown-pairing", {"interior", Pairing::interior},
                         {"outside", Pairing::outside});
}
MeshFaces faces_named(const std::string& name) {
  return one_of<MeshFaces>(name, "unknown-faces", {"polygons", MeshFaces::polygons},
                           {"triangles", MeshFaces::triangles});
}
Precision precision_named(const std::string& name) {
  return one_of<Precision>(name, "unknown-precision", {"float64", Precision::float64},
                           {"float32", Precision::float32});
}

/// Volume, Euler characteristic, vertices, edges, faces.
using ShellRow = std::tuple<ExactNumber, long, std::uint64_t, std::uint64_t, std::size_t>;

std::vector<ShellRow> shell_rows(const PolyhedralSet& set, const std::string& pairing) {
  const SurfaceEdges surface = surface_edges(set);
  std::vector<ShellRow> rows;
  for (const Shell& shell : shells(surface, pairing_named(pairing))) {
    rows.emplace_back(ExactNumber{volume(surface, shell)}, shell.characteristic, shell.vertices,
                      shell.edges, shell.faces.size());
  }
  return rows;
}

std::pair<Surface, Fields> rounded(const Surface& surface, const std::string& precision) {
  RoundedMesh result;
  {
    const Computing computing;
    result = rounded_mesh(surface.value(), precision_named(precision));
  }
  nb::dict fields;
  MINKREF_PUT(result.report, moved_vertices, merged_vertices, degenerate_faces, turned_faces,
              bent_faces)
  fields["largest_displacement"] = to_string(result.report.largest_displacement);
  return {Surface(std::move(result.mesh)), Fields(fields)};
}

Fields topology_fields(const PolyhedralSet& set) {
  SpaceTopology result;
  {
    const Computing computing;
    result = topology(surface_edges(set));
  }
  nb::dict fields;
  MINKREF_PUT(result, components, cavities, tunnels)
  return Fields(fields);
}

}  // namespace

void bind_space_surface(nb::module_& module, nb::class_<PolyhedralSet>& set) {
  set.def("topology", &topology_fields,
          "The connected components of the interior, the bounded ones of the complement "
          "(cavities), and the tunnels: the genera of all shells of the interior, added up.")
      .def("shells", &shell_rows, "pairing"_a = "interior", Released(),
           "Volume (exact, signed), Euler characteristic, vertices, edges and faces of each shell: "
           "a closed surface of faces that are joined at edges across the interior, or across the "
           "outside.")
      .def(
          "mesh",
          [](const PolyhedralSet& self, const std::string& faces) {
            const SurfaceEdges surface = surface_edges(self);
            return Surface(faces_named(faces) == MeshFaces::triangles ? manifold_mesh(surface)
                                                                      : mesh_of(surface));
          },
          "faces"_a = "polygons", Released(),
          "The boundary as a closed mesh. `polygons`: faces are simple polygons where they are "
          "such, else triangles; it conforms, and is not manifold where the set is not. "
          "`triangles`: of triangles that every reader takes: each edge has two, by the numbers of "
          "its vertices; where the set touches itself, several vertices stand at one place. Exact.")
      .def(
          "projected_areas",
          [](const PolyhedralSet& self) {
            const auto areas = projected_areas(self);
            return ExactTriple{{areas[0]}, {areas[1]}, {areas[2]}};
          },
          Released(), "The areas of the projections of all faces along x, y and z, added up.");
  module.def(
      "polyhedral_set", [](const Surface& surface) { return polyhedral_set(surface.value()); },
      "polyhedron"_a, Released(),
      "The set that a valid polyhedron bounds, or a closed mesh whose faces only touch.");
  module.def("rounded_mesh", &rounded, "mesh"_a, "precision"_a = "float64",
             "The mesh with each coordinate the nearest number of that precision (float64 or "
             "float32), and what this has done to it: moved_vertices, merged_vertices, "
             "degenerate_faces, turned_faces, bent_faces, largest_displacement (exact, along an "
             "axis). The faces stay as they are.");
}

}  // namespace minkref::python
