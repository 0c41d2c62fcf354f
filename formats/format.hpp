// The file formats of the plane and their names.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace minkref {

enum class Format {
  wkt,        ///< well-known text
  geojson,    ///< RFC 7946
  poly,       ///< the format of the paper's models: rings marked `out` or `in`
  json,       ///< {"polygons":[{"outer":ring,"holes":[ring,...]}]}; exact
  case_json,  ///< case-v1: two operands with scales and expected results
  svg,        ///< a picture; written only
};

struct FormatEntry {
  Format format;
  std::string_view name;
  bool is_extension;  ///< of files; files of cases end with .json too
  bool is_read;       ///< by that extension
};

/// All formats: commands and Python take their lists from here.
std::span<const FormatEntry> format_table();

/// "wkt", "geojson", "poly", "json", "case", "svg".
std::string name(Format format);

/// The format with a given name. Throws BadInput ("unknown-format").
Format format_named(std::string_view name);

/// A file name's extension, lower case, with its point; "" if none.
std::string extension_of(const std::string& path);

/// The format for a file name's extension (any case); `.json` gives Format::json, whose reader
/// tells GeoJSON and cases by their members. Throws BadInput ("unknown-format").
Format format_of_file(const std::string& path);

}  // namespace minkref
