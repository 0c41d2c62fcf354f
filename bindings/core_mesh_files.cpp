// Reading and writing files of polyhedra from Python.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include "bindings/core.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/read_mesh.hpp"
#include "formats/write_mesh.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// With its warnings.
std::pair<Surface, std::vector<std::string>> keep(MeshReading reading) {
  std::vector<std::string> warnings = std::move(reading.warnings);
  return {Surface{std::move(reading)}, std::move(warnings)};
}

}  // namespace

void bind_mesh_files(nb::module_& module) {
  nb::list names;
  for (const MeshFormatEntry& entry : mesh_format_table()) {
    names.append(nb::str(entry.name.data(), entry.name.size()));
  }
  module.attr("MESH_FORMATS") = nb::tuple(names);
  module.def(
      "read_mesh_file", [](const std::string& path) { return keep(read_mesh_file(path)); },
      "path"_a, Released(),
      "Reads a polyhedron, exact, and gives it with the warnings of the reader; the format by the "
      "extension. Not validated. Raises BadInput.");
  module.def(
      "read_mesh_text",
      [](const nb::bytes& text, const std::string& format, const std::string& source) {
        const std::string_view view(text.c_str(), text.size());
        const Computing computing;
        return keep(read_mesh_text(view, mesh_format_named(format), source));
      },
      "text"_a, "format"_a, "source"_a = "",
      "The same from the bytes of a file in off, obj, stl, ply or json. Raises BadInput.");
  module.def(
      "write_mesh",
      [](const Surface& surface, const std::string& format) {
        return write_mesh(surface.value(), mesh_format_named(format));
      },
      "surface"_a, "format"_a, Released(),
      "The text of a polyhedron in off, obj, stl, ply or json. Raises BadInput.");
  module.def(
      "writes_mesh_exactly",
      [](const Surface& surface, const std::string& format) {
        return writes_exactly(surface.value(), mesh_format_named(format));
      },
      "surface"_a, "format"_a, Released(),
      "Whether reading what `write_mesh` gives yields the same polyhedron.");
}

}  // namespace minkref::python
