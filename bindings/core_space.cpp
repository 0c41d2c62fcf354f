// Polyhedra in Python.
#include "bindings/core_space.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <string>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_shapes.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/error.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/canonical_polyhedron.hpp"
#include "reference/space/face_triangles.hpp"
#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron_place.hpp"
#include "reference/space/surface/manifold_mesh.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

Polyhedron polyhedron_of(const std::vector<ExactSpacePoint>& vertices,
                         const std::vector<Face>& faces) {
  Polyhedron result;
  for (const ExactSpacePoint& vertex : vertices) {
    look_for_interrupt();
    result.vertices.push_back(to_point(vertex));
  }
  result.faces = faces;
  validate_faces(result);
  return result;
}

/// Points from rows of three Python numbers, or from an array.
std::vector<ExactSpacePoint> points_of(const nb::object& vertices) {
  std::vector<ExactSpacePoint> result;
  for (const nb::handle row : vertices) {
    result.push_back(space_point_of(row, "vertex " + std::to_string(result.size())));
  }
  return result;
}

template <class Row>
std::vector<Row> points(const Polyhedron& polyhedron, Row (*row)(const SpacePoint&)) {
  std::vector<Row> result;
  result.reserve(polyhedron.vertices.size());
  for (const SpacePoint& vertex : polyhedron.vertices) {
    look_for_interrupt();
    result.push_back(row(vertex));
  }
  return result;
}

std::vector<std::array<double, 3>> approximate_points(const Polyhedron& polyhedron) {
  std::vector<std::array<double, 3>> result;
  result.reserve(polyhedron.vertices.size());
  for (const SpacePoint& v : polyhedron.vertices) {
    result.push_back({to_double(v.x), to_double(v.y), to_double(v.z)});
  }
  return result;
}

/// Areas of the projections along the axes, each summed over all faces.
ExactTriple projected_areas(const Polyhedron& polyhedron) {
  const IntegerPoints integers = integer_points(polyhedron.vertices);
  IntegerVector twice{0, 0, 0};
  for (const Face& face : polyhedron.faces) {
    const IntegerVector area = area_vector(integers.points, face);
    for (std::size_t k = 0; k < 3; ++k) twice[k] += abs(area[k]);
  }
  const Rational unit(Integer(1), 2 * integers.denominator * integers.denominator);
  return {{twice[0] * unit}, {twice[1] * unit}, {twice[2] * unit}};
}

/// Cuts each face into triangles.
std::vector<std::vector<TriangleCorners>> triangles(const Polyhedron& polyhedron) {
  const IntegerPoints integers = integer_points(polyhedron.vertices);
  const VertexSigns signs(integers.points);
  std::vector<std::vector<TriangleCorners>> result;
  for (std::uint32_t f = 0; f < polyhedron.faces.size(); ++f) {
    const auto cut = face_triangles(polyhedron.faces[f], signs);
    if (!cut) {
      throw BadInput("face-not-simple", "a face cannot be cut into triangles",
                     "split the face where it meets itself",
                     place_in(polyhedron, f, polyhedron.faces[f]));
    }
    result.push_back(*cut);
  }
  return result;
}

/// Other surfaces made from one, and its text.
void bind_changed_surfaces(nb::class_<Surface>& bound) {
  bound
      .def(
          "scaled",
          [](const Surface& self, const ExactSpacePoint& by) {
            return Surface(scaled(self.value(), to_scaling(by)));
          },
          "by"_a, Released(),
          nb::sig("def scaled(self, by: " MINKREF_NUMBER
                  " | collections.abc.Sequence[" MINKREF_NUMBER "]) -> Polyhedron"),
          "About the origin, by one factor or one for each axis.")
      .def(
          "translated",
          [](const Surface& self, const ExactSpacePoint& by) {
            return Surface(translated(self.value(), to_point(by)));
          },
          "by"_a, Released(),
          nb::sig("def translated(self, by: collections.abc.Sequence[" MINKREF_NUMBER
                  "]) -> Polyhedron"))
      .def(
          "with_shared_vertices",
          [](const Surface& self) { return Surface(with_shared_vertices(self.value())); },
          Released(), "One vertex for all that have the same coordinates.")
      .def(
          "canonical_json", [](const Surface& self) { return canonical_json(self.value()); },
          Released(), "The text of which the digest is taken; of a surface in canonical form.");
}

}  // namespace

ExactSpacePoint space_point_of(nb::handle row, const std::string& where) {
  if (nb::isinstance<nb::str>(row)) {  // else its characters were the coordinates
    throw BadInput("not-a-point", where + " is a text", "give x, y and z");
  }
  std::array<std::string, 3> texts;
  std::size_t count = 0;
  for (const nb::handle number : row) {
    if (count < texts.size()) texts[count] = number_text(number, where);
    ++count;
  }
  if (count != texts.size()) {
    throw BadInput("not-a-point", where + " has " + std::to_string(count) + " coordinates",
                   "give x, y and z");
  }
  return {texts[0], texts[1], texts[2]};
}

void bind_space(nb::module_& module) {
  nb::class_<Surface> bound(module, "Polyhedron",
                            "A closed surface of planar faces, exact; faces run counter-clockwise "
                            "seen from outside. Without faces: the empty set, a point, a segment.");
  bind_changed_surfaces(bound);
  unchanging(std::move(bound))
      .def(
          "__init__",
          [](Surface* self, const nb::object& vertices, const std::vector<Face>& faces) {
            const std::vector<ExactSpacePoint> points = points_of(vertices);
            const Computing computing;
            new (self) Surface(polyhedron_of(points, faces));
          },
          "vertices"_a, "faces"_a,
          "From points (x, y, z), whose numbers count by their exact value as those of PolygonSet, "
          "and for each face the numbers of its vertices. Refuses (BadInput) a face that names no "
          "vertex, or has fewer than three.")
      .def(
          "__getstate__",
          [](const Surface& self) {
            return std::pair(points<ExactSpacePoint>(self.value(), to_strings), self.value().faces);
          },
          Released())
      .def(
          "__setstate__",
          [](Surface& self,
             const std::pair<std::vector<ExactSpacePoint>, std::vector<Face>>& state) {
            new (&self) Surface(polyhedron_of(state.first, state.second));
          },
          Released())
      .def("__repr__",
           [](const Surface& self) {
             return "<Polyhedron: " + std::to_string(self.value().vertices.size()) + " vertices, " +
                    std::to_string(self.value().faces.size()) + " faces>";
           })
      .def(
          "points", [](const Surface& self) { return points(self.value(), exact_point); },
          Released(), "The vertices, exact: triples of Fractions.")
      .def(
          "written_points",
          [](const Surface& self) { return points<ExactSpacePoint>(self.value(), to_strings); },
          Released(), "The vertices as documents have them: texts of exact numbers.")
      .def(
          "approximate_points",
          [](const Surface& self) { return approximate_points(self.value()); }, Released(),
          "The nearest doubles, for drawing.")
      .def(
          "rings", [](const Surface& self) { return self.value().faces; }, Released(),
          "For each face the numbers of its vertices.")
      .def(
          "triangles", [](const Surface& self) { return triangles(self.value()); }, Released(),
          "Of each face, planar and simple, the triangles into which diagonals cut it, by the "
          "numbers of their vertices. Exact.")
      .def(
          "cut_into_triangles",
          [](const Surface& self) { return Surface(cut_into_triangles(self.value())); }, Released(),
          "The same surface of triangles of positive area with its vertices; a diagonal that "
          "would run along an edge elsewhere is cut in its middle. Exact.")
      .def_prop_ro("vertices", [](const Surface& self) { return self.value().vertices.size(); })
      .def_prop_ro("faces", [](const Surface& self) { return self.value().faces.size(); })
      .def(
          "validate",
          [](const Surface& self, const std::string& source) {
            validate_as_read(self.reading, source);
          },
          "source"_a = "", Released(),
          "Refuses what is no closed 2-manifold of planar simple faces, crosses or covers itself, "
          "or has a shell in the material of another (BadInput). Exact.")
      .def(
          "validate_summand",
          [](const Surface& self, const std::string& source) {
            validate_summand_as_read(self.reading, source);
          },
          "source"_a = "", Released(),
          "The same, but takes a plane polygon as well: a single face. Exact.")
      .def(
          "sextuple_volume",
          [](const Surface& self) { return ExactNumber{sextuple_volume(self.value())}; },
          Released(), "Six times the volume. Exact.")
      .def(
          "projected_areas", [](const Surface& self) { return projected_areas(self.value()); },
          Released(),
          "The areas of the projections of all faces along x, y and z, added up, whether they hide "
          "each other or not. Exact.");
}

}  // namespace minkref::python
