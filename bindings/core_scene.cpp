// The union of a scene's placed sums for Python.
#include "bindings/core_scene.hpp"

#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <map>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/core_fields.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/scene/scene_union.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// Shape, scale, x, y.
using CopyRow = std::tuple<std::uint32_t, std::string, std::string, std::string>;

/// Copy, and the convolution edge as a row of reduced_convolution's.
using OwnerRow = std::pair<std::uint32_t, EdgeRow>;
using OwnerRows = std::vector<OwnerRow>;

Copy copy_of(const CopyRow& row) {
  const auto& [shape, scale, x, y] = row;
  return {shape, parse_rational(scale), {parse_rational(x), parse_rational(y)}};
}

Scene scene_of(const Set& robot, const std::vector<Set>& shapes,
               const std::vector<CopyRow>& copies) {
  Scene scene{robot.value, {}, {}};
  for (const Set& shape : shapes) scene.shapes.push_back(shape.value);
  scene.copies.reserve(copies.size());
  for (const CopyRow& row : copies) {
    look_for_interrupt();
    scene.copies.push_back(copy_of(row));
  }
  return scene;
}

/// Changes use the scene's threads.
struct BoundScene {
  SceneUnion scene;
  unsigned threads = 1;
  std::uint64_t memory = 0;

  BuildOptions options() const { return limited(build_on(threads), memory); }
  static BuildOptions limited(BuildOptions options, std::uint64_t memory) {
    if (memory != 0) options.memory_limit = memory;
    return options;
  }
};

OwnerRows owner_rows(const std::vector<Owner>& owners) {
  std::vector<ConvolutionEdge> edges;
  edges.reserve(owners.size());
  for (const Owner& owner : owners) edges.push_back(owner.edge);
  std::vector<EdgeRow> named = convolution_rows(edges);
  OwnerRows rows;
  rows.reserve(owners.size());
  for (std::size_t k = 0; k < owners.size(); ++k)
    rows.emplace_back(owners[k].copy, std::move(named[k]));
  return rows;
}

std::vector<std::vector<OwnerRows>> owners_of(const BoundScene& self) {
  std::vector<std::vector<OwnerRows>> rings;
  for (const RingOwners& ring : self.scene.owners()) {
    auto& sides = rings.emplace_back();
    for (const auto& owners : ring) sides.push_back(owner_rows(owners));
  }
  return rings;
}

std::vector<std::pair<std::vector<ExactPoint>, std::vector<OwnerRows>>> passages_of(
    const BoundScene& self) {
  std::vector<std::pair<std::vector<ExactPoint>, std::vector<OwnerRows>>> rows;
  for (const ScenePassage& passage : self.scene.passages()) {
    auto& [points, owners] = rows.emplace_back();
    for (const Point& point : passage.points) points.push_back(to_strings(point));
    for (const auto& own : passage.owners) owners.push_back(owner_rows(own));
  }
  return rows;
}

std::vector<ExactPoint> ring_of(const Ring& ring) {
  std::vector<ExactPoint> points;
  points.reserve(ring.size());
  for (const Point& point : ring) points.push_back(to_strings(point));
  return points;
}

/// A cell: its component, outer ring (empty: without bound), holes.
using CellRow =
    std::tuple<std::uint32_t, std::vector<ExactPoint>, std::vector<std::vector<ExactPoint>>>;

std::pair<std::size_t, std::vector<CellRow>> free_components_of(const BoundScene& self,
                                                                const std::string& rule) {
  const FreeComponents found = self.scene.components(contact_rule(rule));
  std::vector<CellRow> rows;
  for (std::size_t k = 0; k < found.cells.size(); ++k) {
    look_for_interrupt();
    auto& [component, outer, holes] = rows.emplace_back();
    component = found.of_cell[k];
    outer = ring_of(found.cells[k].outer);
    for (const Ring& hole : found.cells[k].holes) holes.push_back(ring_of(hole));
  }
  return {found.count, std::move(rows)};
}

std::vector<CopyRow> copies_of(const BoundScene& self) {
  std::vector<CopyRow> rows;
  for (const Copy& copy : self.scene.copies()) {
    rows.emplace_back(copy.shape, to_string(copy.scale), to_string(copy.place.x),
                      to_string(copy.place.y));
  }
  return rows;
}

std::map<std::string, std::uint64_t> counts_of(const BoundScene& self) {
  const SceneCounts& counts = self.scene.counts();
  std::map<std::string, std::uint64_t> fields;
  MINKREF_PUT(counts, copies_redone, edges_redone, sums_evaluated, indices_built);
  return fields;
}

BoundScene changed(const BoundScene& self, std::uint32_t copy, const std::string& scale,
                   const std::string& x, const std::string& y) {
  return {self.scene.changed(copy, parse_rational(scale), {parse_rational(x), parse_rational(y)},
                             self.options()),
          self.threads, self.memory};
}

BoundScene added(const BoundScene& self, std::uint32_t shape, const std::string& scale,
                 const std::string& x, const std::string& y) {
  return {self.scene.added(copy_of({shape, scale, x, y}), self.options()), self.threads,
          self.memory};
}

BoundScene removed(const BoundScene& self, std::uint32_t copy) {
  return {self.scene.removed(copy, self.options()), self.threads, self.memory};
}

}  // namespace

void bind_scene(nb::module_& module) {
  unchanging(nb::class_<BoundScene>(
                 module, "SceneUnion",
                 "The union of the placed sums of scaled copies with the reflected robot: where "
                 "the robot meets a copy. A value: a change gives a new one. Exact."))
      .def(
          "__init__",
          [](BoundScene* self, const Set& robot, const std::vector<Set>& shapes,
             const std::vector<CopyRow>& copies, bool passages, unsigned threads,
             std::uint64_t memory, const std::optional<Progress>& progress) {
            const Computing released;
            const BuildOptions options = BoundScene::limited(build_on(threads, progress), memory);
            new (self) BoundScene{SceneUnion(scene_of(robot, shapes, copies), passages, options),
                                  threads, memory};
          },
          "robot"_a, "shapes"_a, "copies"_a, "passages"_a = false, "threads"_a = 1, "memory"_a = 0,
          "progress"_a = nb::none(),
          "Copies are (shape, scale, x, y). Tight passages are found if asked for here. Raises "
          "BadInput (bad-scale, no-shape, no-area), LimitExceeded.")
      .def("changed", changed, "copy"_a, "scale"_a, "x"_a, "y"_a, Released(),
           "With another scale and place for a copy. Raises BadInput (no-copy, bad-scale).")
      .def("added", added, "shape"_a, "scale"_a, "x"_a, "y"_a, Released(),
           "With one copy more, the last.")
      .def("removed", removed, "copy"_a, Released(), "Without a copy: later copies move up by one.")
      .def_prop_ro("copies", copies_of, Released(), "Rows (shape, scale, x, y).")
      .def(
          "region", [](const BoundScene& self) { return Set{self.scene.region().region, true}; },
          Released(), "The union in canonical form; found when first asked for, and kept.")
      .def_prop_ro(
          "components_of_set",
          [](const BoundScene& self) { return self.scene.region().components; }, Released(),
          "Connected components of the union's interior.")
      .def_prop_ro(
          "holes", [](const BoundScene& self) { return self.scene.region().holes; }, Released(),
          "Bounded components of the union's complement.")
      .def("owners", owners_of, Released(),
           "For each ring of region() (outer ring, holes, outer ring, ...) and each side, from a "
           "vertex to the next: (copy, row of reduced_convolution of shape and reflected robot).")
      .def("passages", passages_of, Released(),
           "The tight passages: (points, owners of each segment). Raises BadInput (no-passages) "
           "for a scene made without.")
      .def("free_components", free_components_of, "rule"_a, Released(),
           "The number of free components by a rule of contact (allowed, forbidden), and the cells "
           "of the union's complement, the one without bound first: (component, outer ring, "
           "holes). Components without a cell are tight passages. Raises BadInput (no-passages).")
      .def("counts", counts_of,
           "The work of the last change, or of the scene: copies and edges done again, sums.")
      .def(
          "sum_of",
          [](const BoundScene& self, std::uint32_t copy) {
            return Set{self.scene.sum_of(copy).region, true};
          },
          "copy"_a, Released(), "The placed sum of a copy in canonical form.");
}

}  // namespace minkref::python
