// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/polygon.hpp"

#include <string_view>

namespace minkref::cgal_oracle {
namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

mpq_class read_number(const nlohmann::json& value, const std::string& name) {
  if (!value.is_string())
    throw BadOperand(name + ": a coordinate is not a string: " + value.dump());
  const auto& text = value.get_ref<const std::string&>();
  std::string_view rest = text;
  if (rest.starts_with('-')) rest.remove_prefix(1);
  const auto slash = rest.find('/');
  const auto numerator = rest.substr(0, slash);
  const auto denominator = slash == std::string_view::npos ? "1" : rest.substr(slash + 1);
  if (!is_digits(numerator) || !is_digits(denominator) ||
      denominator.find_first_not_of('0') == std::string_view::npos) {
    throw BadOperand(name + ": not a number n or n/d: \"" + text + '"');
  }
  mpq_class number(text, 10);
  number.canonicalize();
  return number;
}

namespace {

Ring read_ring(const nlohmann::json& value, const std::string& name) {
  if (!value.is_array()) throw BadOperand(name + ": a ring is not an array");
  Ring ring;
  ring.reserve(value.size());
  for (const auto& vertex : value) {
    if (!vertex.is_array() || vertex.size() != 2) {
      throw BadOperand(name + ": a vertex is not [\"x\",\"y\"]");
    }
    ring.push_back({read_number(vertex[0], name), read_number(vertex[1], name)});
  }
  return ring;
}

nlohmann::json write_ring(const Ring& ring) {
  auto value = nlohmann::json::array();
  for (const auto& vertex : ring) value.push_back({vertex.x.get_str(), vertex.y.get_str()});
  return value;
}

}  // namespace

std::vector<Polygon> read_polygons(const nlohmann::json& value, const std::string& name) {
  if (!value.is_object() || !value.contains("polygons") || !value["polygons"].is_array()) {
    throw BadOperand(name + ": not an object with an array \"polygons\"");
  }
  std::vector<Polygon> polygons;
  for (const auto& item : value["polygons"]) {
    if (!item.is_object() || !item.contains("outer")) {
      throw BadOperand(name + ": a polygon has no \"outer\"");
    }
    auto& polygon = polygons.emplace_back();
    polygon.outer = read_ring(item["outer"], name);
    if (!item.contains("holes")) continue;
    if (!item["holes"].is_array()) throw BadOperand(name + ": \"holes\" is not an array");
    for (const auto& hole : item["holes"]) polygon.holes.push_back(read_ring(hole, name));
  }
  return polygons;
}

nlohmann::json write_polygons(const std::vector<Polygon>& polygons) {
  auto list = nlohmann::json::array();
  for (const auto& polygon : polygons) {
    auto holes = nlohmann::json::array();
    for (const auto& hole : polygon.holes) holes.push_back(write_ring(hole));
    list.push_back({{"holes", std::move(holes)}, {"outer", write_ring(polygon.outer)}});
  }
  return {{"polygons", std::move(list)}};
}

}  // namespace minkref::cgal_oracle
