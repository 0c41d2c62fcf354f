#include "formats/format.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "formats/format_names.hpp"

namespace minkref {
namespace {

constexpr std::array<FormatEntry, 6> table{{
    {Format::wkt, "wkt", true, true},
    {Format::geojson, "geojson", true, true},
    {Format::poly, "poly", true, true},
    {Format::json, "json", true, true},
    {Format::case_json, "case", false, false},
    {Format::svg, "svg", true, false},
}};

}  // namespace

std::span<const FormatEntry> format_table() { return table; }

std::string name(Format format) {
  return std::string(std::find_if(table.begin(), table.end(), [&](const auto& e) {
                       return e.format == format;
                     })->name);
}

Format format_named(std::string_view wanted) {
  return named(format_table(), wanted, "of the plane");
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

Format format_of_file(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const FormatEntry& entry : table) {
    if (entry.is_extension && extension == "." + std::string(entry.name)) return entry.format;
  }
  refuse_extension(format_table(), path, extension, "of the plane", &FormatEntry::is_read);
}

}  // namespace minkref
