// Reading and writing files from Python.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include "bindings/core.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/read.hpp"
#include "formats/write.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

Set kept(Reading reading) {
  return {std::move(reading.set), false, std::move(reading.origins), std::move(reading.warnings)};
}

std::pair<Set, std::vector<int>> kept_with_faults(FaultyReading faulty) {
  std::vector<int> open(faulty.open.begin(), faulty.open.end());
  return {kept(std::move(faulty.reading)), std::move(open)};
}

}  // namespace

void bind_files(nb::module_& module) {
  nb::dict formats;
  for (const FormatEntry& entry : format_table()) {
    if (entry.is_extension) {
      formats[nb::str(entry.name.data(), entry.name.size())] = entry.is_read;
    }
  }
  module.attr("SET_FORMATS") = formats;
  module.def(
      "read_file", [](const std::string& path) { return kept(read_file(path)); }, "path"_a,
      Released(), "Reads an operand, exact; the format by the extension. Raises BadInput.");
  module.def(
      "read_text",
      [](const std::string& text, const std::string& format, const std::string& source) {
        return kept(read_text(text, format_named(format), source));
      },
      "text"_a, "format"_a, "source"_a = "", Released(),
      "Reads an operand from text in wkt, geojson, poly, json or case. Raises BadInput.");
  module.def(
      "read_faulty_file",
      [](const std::string& path) { return kept_with_faults(read_faulty_file(path)); }, "path"_a,
      Released(),
      "Reads rings as written, also those whose faults `minkref repair` mends; and of each ring "
      "1 if it is open, in formats that repeat the first vertex, else 0. Raises BadInput.");
  module.def(
      "read_faulty_text",
      [](const std::string& text, const std::string& format, const std::string& source) {
        return kept_with_faults(read_faulty_text(text, format_named(format), source));
      },
      "text"_a, "format"_a, "source"_a = "", Released(),
      "The same from text in wkt, geojson, poly or json. Raises BadInput.");
  module.def(
      "write",
      [](const Set& set, const std::string& format) {
        return write(set.value, format_named(format));
      },
      "set"_a, "format"_a, Released(), "The text of a set in wkt, geojson, poly, json or svg.");
  module.def(
      "writes_exactly",
      [](const Set& set, const std::string& format) {
        return writes_exactly(set.value, format_named(format));
      },
      "set"_a, "format"_a, Released(), "Whether reading what `write` gives yields the same set.");
}

}  // namespace minkref::python
