#include "formats/read_json.hpp"

#include <utility>

#include "formats/json_object.hpp"

namespace minkref {
namespace {

TextRing read_ring(Json value, SetBuilder& set, JsonNumbers numbers) {
  Input& input = set.input();
  expect(value, JsonKind::array, "a ring", input);
  TextRing ring = set.ring(value.line());
  for (const Json pair : value) {
    Place where = ring.place_of(ring.points.size());
    where.line = pair.line();
    if (!pair.is(JsonKind::array) || pair.size() != 2) {
      const bool deeper = pair.is(JsonKind::array) && pair.size() > 2;
      input.refuse(deeper ? "three-dimensional" : "wrong-type",
                   "a vertex must be an array of two numbers", "write [\"x\", \"y\"]", where);
    }
    const std::string x = number_text(*pair.begin(), numbers, input, where);
    const std::string y = number_text(*++pair.begin(), numbers, input, where);
    set.vertex(ring, x, y, pair.line());
  }
  return ring;
}

}  // namespace

std::string number_text(Json value, JsonNumbers numbers, const Input& input, const Place& place) {
  if (value.is(JsonKind::string)) return value.string();
  if (!value.is(JsonKind::number)) {
    input.refuse("not-a-number", "expected a number, not " + describe(value.kind()),
                 "write a string such as \"3/7\" or \"-30.7428\", or a JSON number", place);
  }
  const std::string_view text = value.text();
  if (numbers == JsonNumbers::integers && text.find_first_of(".eE") != std::string_view::npos) {
    input.refuse("not-a-number",
                 "a JSON number that is not an integer is not exact to every reader",
                 "put it in quotes: \"" + std::string(text.substr(0, 40)) + "\"", place);
  }
  return std::string(text);
}

void read_json_set(Json value, SetBuilder& set, JsonNumbers numbers) {
  const Input& input = set.input();
  const JsonObject members(value, input, "a polygon set", {"polygons"},
                           JsonObject::Others::refused);
  const Json polygons = members.require("polygons");
  expect(polygons, JsonKind::array, "polygons", input);
  for (const Json polygon : polygons) {
    const JsonObject parts(polygon, input, "a polygon", {"outer", "holes"},
                           JsonObject::Others::refused);
    TextRing outer = read_ring(parts.require("outer"), set, numbers);
    std::vector<TextRing> holes;
    if (const auto list = parts.find("holes")) {
      expect(*list, JsonKind::array, "holes", input);
      for (const Json hole : *list) holes.push_back(read_ring(hole, set, numbers));
    }
    set.polygon(std::move(outer), std::move(holes));
  }
}

}  // namespace minkref
