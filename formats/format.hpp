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
  bool is_extension;  ///< of files; those of cases end in .json too
  bool is_read;       ///< by that extension
};

/// All of them: commands and Python take their lists from here.
std::span<const FormatEntry> format_table();

/// "wkt", "geojson", "poly", "json", "case", "svg".
std::string name(Format format);

/// The format of that name. Throws BadInput ("unknown-format").
Format format_named(std::string_view name);

/// The extension of a file name in small letters, with its point; "" where there is none.
std::string extension_of(const std::string& path);

/// The format by the extension of a file name (any case); `.json` is Format::json, whose reader
/// tells GeoJSON and cases by their members. Throws BadInput ("unknown-format").
Format format_of_file(const std::string& path);

}  // namespace minkref
