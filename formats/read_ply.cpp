#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "formats/file_text.hpp"
#include "formats/mesh_builder.hpp"
#include "formats/mesh_formats.hpp"
#include "formats/message_text.hpp"
#include "formats/ply_header.hpp"
#include "formats/ply_values.hpp"

namespace minkref {
namespace {

/// A property's index within its element. Refuses a property given twice.
std::optional<std::size_t> find(const PlyElement& element, std::string_view name,
                                std::string_view other_name, const Input& input) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const std::string& own = element.properties[k].name;
    if (own != name && own != other_name) continue;
    if (found) {
      input.refuse("duplicate-property",
                   "the element " + in_quotes(element.name) + " has the property " +
                       in_quotes(own) + " twice",
                   "keep one of them", element.line);
    }
    found = k;
  }
  return found;
}

std::size_t require(const PlyElement& element, std::string_view name, std::string_view other_name,
                    bool list, const Input& input) {
  const auto found = find(element, name, other_name, input);
  if (!found) {
    input.refuse("missing-property",
                 "the element " + in_quotes(element.name) + " has no property " + in_quotes(name),
                 "add it to the header and to the body", element.line);
  }
  const PlyProperty& property = element.properties[*found];
  if (property.length.has_value() != list || (list && !is_integer(property.type))) {
    input.refuse("wrong-type",
                 "the property " + in_quotes(property.name) + " must be " +
                     (list ? "a list of integers" : "one number, not a list"),
                 "correct the header and the body", element.line);
  }
  return *found;
}

template <class Values>
class PlyReader {
 public:
  PlyReader(std::string_view file, const PlyHeader& header, Input& input)
      : header_(header), mesh_(input, Values::positions), values_(file, header, input) {}

  MeshReading run() {
    require_one_of_each();
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0) continue;
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        skip_all(element);
      }
    }
    values_.finish();
    return mesh_.finish();
  }

 private:
  const Input& input() const { return mesh_.input(); }

  void require_one_of_each() const {
    bool has_vertices = false, has_faces = false;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "tristrips" && element.count > 0) {
        input().refuse("unsupported-geometry", "the file holds triangle strips",
                       "save it with faces: elements `face` with vertex_indices", element.line);
      }
      if (element.name == "vertex") require_first(element, has_vertices);
      if (element.name == "face") require_first(element, has_faces);
    }
  }

  void require_first(const PlyElement& element, bool& seen) const {
    if (seen) {
      input().refuse("duplicate-element",
                     "the element " + in_quotes(element.name) + " is given twice",
                     "keep one of them", element.line);
    }
    seen = true;
  }

  void skip(const PlyProperty& property) {
    values_.skip(property.type, property.length ? length(property) : 1);
  }

  std::uint64_t length(const PlyProperty& property) {
    const std::int64_t length = values_.integer(*property.length);
    if (length < 0) {
      Place place = at_line(Values::positions == Positions::lines ? values_.position() : 0);
      input().refuse("syntax", "a list has the length " + std::to_string(length),
                     "a length is 0 or more", place);
    }
    return static_cast<std::uint64_t>(length);
  }

  void skip_all(const PlyElement& element) {
    for (std::size_t row = 0; row < element.count; ++row) {
      values_.begin(element, row);
      for (const PlyProperty& property : element.properties) skip(property);
      values_.end();
    }
  }

  void read_vertices(const PlyElement& element) {
    const std::array<std::size_t, 3> axes = {require(element, "x", "x", false, input()),
                                             require(element, "y", "y", false, input()),
                                             require(element, "z", "z", false, input())};
    for (std::size_t row = 0; row < element.count; ++row) {
      values_.begin(element, row);
      std::array<typename Values::Number, 3> point{};
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const auto axis = std::find(axes.begin(), axes.end(), k);
        if (axis == axes.end()) {
          skip(property);
        } else {
          point[static_cast<std::size_t>(axis - axes.begin())] = values_.number(property.type);
        }
      }
      mesh_.vertex(point, values_.position());
      values_.end();
    }
  }

  void read_faces(const PlyElement& element) {
    const std::size_t indices = require(element, "vertex_indices", "vertex_index", true, input());
    for (std::size_t row = 0; row < element.count; ++row) {
      values_.begin(element, row);
      mesh_.begin_face(values_.position());
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (k == indices) {
          for (std::uint64_t left = length(property); left > 0; --left) corner(property.type);
        } else {
          skip(property);
        }
      }
      mesh_.end_face();
      values_.end();
    }
  }

  void corner(PlyType type) {
    const std::int64_t index = values_.integer(type);
    if (index < 0) mesh_.refuse_corner(std::to_string(index), "vertices are numbered from 0");
    mesh_.corner(static_cast<std::uint64_t>(index));
  }

  const PlyHeader& header_;
  MeshBuilder mesh_;
  Values values_;
};

}  // namespace

MeshReading read_ply(std::string_view file, Input& input) {
  require_size(file, input.source(), input.limits());
  if (is_binary_ply(file)) {
    const PlyHeader header = read_ply_header(file, input);
    return PlyReader<PlyBytes>(file, header, input).run();
  }
  const std::string_view text =
      plain_text(file, input.source(), input.limits(), "a header of no vertices and no faces");
  const PlyHeader header = read_ply_header(text, input);
  return PlyReader<PlyText>(text, header, input).run();
}

}  // namespace minkref
