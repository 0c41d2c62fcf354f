#include "python/core_shapes.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <limits>
#include <utility>

#include "formats/refusal_place.hpp"
#include "python/vector_caster.hpp"

namespace nb = nanobind;

namespace minkref::python {
namespace {

constexpr std::size_t most_shown = 12;  // vertices that a text shows one by one

Ring ring_of(const std::vector<ExactPoint>& texts) {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max() / 2;
  const NumberLimits limits{any, std::numeric_limits<long>::max()};
  Ring ring;
  ring.reserve(texts.size());
  for (const auto& [x, y] : texts) {
    ring.push_back({parse_rational(x, limits), parse_rational(y, limits)});
  }
  return ring;
}

PolygonSet set_of_rings(const std::vector<TextPolygon>& polygons) {
  PolygonSet result;
  for (const TextPolygon& rings : polygons) {
    if (rings.empty()) continue;  // GeoJSON's empty polygon
    Polygon& polygon = result.polygons.emplace_back();
    polygon.outer = ring_of(rings.front());
    for (std::size_t hole = 1; hole < rings.size(); ++hole) {
      polygon.holes.push_back(ring_of(rings[hole]));
    }
  }
  return result;
}

nb::object integer(const Integer& value) {
  const std::string text = (value < 0 ? "-" : "") + Integer(abs(value)).str(0, std::ios::hex);
  return nb::steal(PyLong_FromString(text.c_str(), nullptr, 16));
}

std::string shown(const Rational& value) {
  const std::string text = to_string(value);
  return denominator(value) == 1 ? text : "'" + text + "'";
}

std::string shown(const Ring& ring) {
  std::string text;
  for (const Point& point : ring) {
    text += (text.empty() ? "(" : ", (") + shown(point.x) + ", " + shown(point.y) + ")";
  }
  return "[" + text + "]";
}

/// Lists of what `make` gives of each ring: the outer one of a polygon, then its holes.
template <class Make>
nb::list each_ring(const Set& set, const Make& make) {
  nb::list polygons;
  for (const Polygon& polygon : set.value.polygons) {
    nb::list rings;
    rings.append(make(polygon.outer));
    for (const Ring& hole : polygon.holes) rings.append(make(hole));
    polygons.append(rings);
  }
  return polygons;
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Set set_of_shape(const nb::object& shape, bool validated) {
  const nb::object read = nb::module_::import_("minkref.shapes").attr("set_or_polygons")(shape);
  Set result;
  if (nb::isinstance<Set>(read)) {
    result = nb::cast<const Set&>(read);
  } else {
    const auto polygons = nb::cast<std::vector<TextPolygon>>(read);
    const Computing computing;
    result.value = set_of_rings(polygons);
    if (validated) orient(result.value);
  }
  if (validated && !result.canonical) {
    const Computing computing;
    validate_as_read(result.value, result.origins, "PolygonSet");
  }
  return result;
}

std::string number_text(nb::handle value, const std::string& where) {
  if (nb::isinstance<nb::str>(value)) return nb::cast<std::string>(value);
  const nb::object read = nb::module_::import_("minkref.shapes").attr("number_text");
  return nb::cast<std::string>(read(value, where));
}

nb::list exact_rings(const Set& set) {
  const nb::object fraction = nb::module_::import_("fractions").attr("Fraction");
  const auto number = [&](const Rational& value) {
    return fraction(integer(numerator(value)), integer(denominator(value)));
  };
  return each_ring(set, [&](const Ring& ring) {
    nb::list points;
    for (const Point& point : ring) points.append(nb::make_tuple(number(point.x), number(point.y)));
    return points;
  });
}

nb::list arrays_of_doubles(const Set& set) {
  return each_ring(set, [](const Ring& ring) {
    auto* values = new double[2 * ring.size()];
    const nb::capsule owner(values, [](void* p) noexcept { delete[] static_cast<double*>(p); });
    for (std::size_t i = 0; i < ring.size(); ++i) {
      values[2 * i] = to_double(ring[i].x);
      values[2 * i + 1] = to_double(ring[i].y);
    }
    return nb::cast(nb::ndarray<nb::numpy, double>(values, {ring.size(), 2}, owner));
  });
}

std::string shown(const Set& set) {
  const PolygonSet& value = set.value;
  if (value.empty()) return "PolygonSet()";
  if (value.vertices() > most_shown) {
    const std::size_t polygons = value.polygons.size();
    return "<PolygonSet: " + counted(polygons, "polygon") + ", " +
           counted(value.rings() - polygons, "hole") + ", " + std::to_string(value.vertices()) +
           " vertices>";
  }
  std::string text;
  for (const Polygon& polygon : value.polygons) {
    text += (text.empty() ? "[" : ", [") + shown(polygon.outer);
    for (const Ring& hole : polygon.holes) text += ", " + shown(hole);
    text += "]";
  }
  return "PolygonSet([" + text + "])";
}

}  // namespace minkref::python
