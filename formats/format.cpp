#include "formats/format.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "formats/message_text.hpp"
#include "reference/error.hpp"

namespace minkref {
namespace {

constexpr std::array<std::pair<Format, std::string_view>, 6> set_formats{{
    {Format::wkt, "wkt"},
    {Format::geojson, "geojson"},
    {Format::poly, "poly"},
    {Format::json, "json"},
    {Format::case_json, "case"},
    {Format::svg, "svg"},
}};

}  // namespace

std::string name(Format format) {
  for (const auto& [value, text] : set_formats) {
    if (value == format) return std::string(text);
  }
  return "unknown";
}

Format format_named(std::string_view wanted) {
  for (const auto& [value, text] : set_formats) {
    if (text == wanted) return value;
  }
  throw BadInput("unknown-format", in_quotes(wanted) + " is not a format of the plane",
                 "name one of wkt, geojson, poly, json, case, svg");
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
  if (extension == ".wkt") return Format::wkt;
  if (extension == ".geojson") return Format::geojson;
  if (extension == ".json") return Format::json;
  if (extension == ".poly") return Format::poly;
  if (extension == ".svg") return Format::svg;
  Place place;
  place.source = path;
  throw BadInput("unknown-format",
                 "the extension " + in_quotes(extension) + " does not name a format of the plane",
                 "give the file the extension .wkt, .geojson, .json or .poly", place);
}

}  // namespace minkref
