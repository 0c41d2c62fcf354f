#include "bindings/core_shapes.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bindings/exact_number.hpp"
#include "bindings/vector_caster.hpp"
#include "formats/refusal_place.hpp"
#include "formats/set_builder.hpp"
#include "reference/error.hpp"
#include "reference/number/message_number.hpp"

namespace nb = nanobind;

namespace minkref::python {
namespace {

constexpr std::size_t most_shown = 12;  // vertices that a text shows one by one

/// A part of a shape: its GeoJSON type, or "rings", which need not be closed; and its rings.
using TextPart = std::pair<std::string, std::vector<std::vector<ExactPoint>>>;

void add(const TextPart& part, SetBuilder& set) {
  const auto& [kind, texts] = part;
  if (texts.empty()) return;  // GeoJSON's empty polygon
  std::vector<TextRing> rings;
  for (const auto& points : texts) {
    TextRing& ring = rings.emplace_back(set.ring(0));
    for (const auto& [x, y] : points) set.vertex(ring, x, y, 0);
    if (kind == "Polygon") set.close(ring);
  }
  TextRing first = std::move(rings.front());
  rings.erase(rings.begin());
  if (kind == "Point") {
    set.point(std::move(first));
  } else if (kind == "LineString") {
    set.line(first, "LineString", "positions");
  } else {
    set.polygon(std::move(first), std::move(rings));
  }
}

/// Refuses the same faults as a reader of files, with the same code.
Reading reading_of(const std::vector<TextPart>& parts, bool turned) {
  const ReadLimits limits = no_limits();
  Input input("PolygonSet", limits);
  SetBuilder set(input);
  for (const TextPart& part : parts) add(part, set);
  Reading reading = turned ? set.finish() : set.finish_as_read();
  for (RingOrigin& origin : reading.origins) {
    std::fill(origin.lines.begin(), origin.lines.end(), 0);  // values stand on no line
  }
  return reading;
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

/// Lists the results of `make` for each polygon's rings: the outer ring, then its holes.
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

ReadLimits no_limits() {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / 2;
  ReadLimits limits;
  limits.number = {most, std::numeric_limits<long>::max()};
  limits.bytes = limits.vertices = limits.json_values = limits.number_bytes =
      limits.containment_steps = most;
  return limits;
}

Set set_of_shape(const nb::object& shape, bool validated) {
  const nb::object read = nb::module_::import_("minkref.plane.shapes").attr("set_or_parts")(shape);
  Set result;
  if (nb::isinstance<Set>(read)) {
    result = nb::cast<const Set&>(read);
  } else {
    const auto parts = nb::cast<std::vector<TextPart>>(read);
    const Computing computing;
    Reading reading = reading_of(parts, validated);
    result.value = std::move(reading.set);
    result.origins = std::move(reading.origins);
  }
  if (validated && !result.canonical) {
    const Computing computing;
    validate_as_read(result.value, result.origins, "PolygonSet", Lines::allowed);
  }
  return result;
}

std::string number_text(nb::handle value, const std::string& where) {
  if (nb::isinstance<nb::str>(value)) return nb::cast<std::string>(value);
  const nb::object read = nb::module_::import_("minkref.plane.shapes").attr("number_text");
  return nb::cast<std::string>(read(value, where));
}

nb::object fraction_of(const Rational& value) {
  static const nb::handle fraction =
      nb::object(nb::module_::import_("fractions").attr("Fraction")).release();
  return fraction(integer(numerator(value)), integer(denominator(value)));
}

nb::object quantity(const Rational& value) {
  return nb::module_::import_("minkref.quantity").attr("Quantity")(to_string(value));
}

nb::list exact_rings(const Set& set) {
  return each_ring(set, [&](const Ring& ring) {
    nb::list points;
    for (const Point& point : ring)
      points.append(nb::make_tuple(fraction_of(point.x), fraction_of(point.y)));
    return points;
  });
}

double finite_double(const Rational& coordinate) {
  const double nearest = to_double(coordinate);
  if (std::isfinite(nearest)) return nearest;
  throw LimitExceeded(
      "not-representable",
      "the coordinate " + message_text(coordinate) + " is beyond the range of doubles",
      "scale the set, or take its exact coordinates, rings()");
}

nb::list arrays_of_doubles(const Set& set) {
  return each_ring(set, [](const Ring& ring) {
    auto* values = new double[2 * ring.size()];
    const nb::capsule owner(values, [](void* p) noexcept { delete[] static_cast<double*>(p); });
    for (std::size_t i = 0; i < ring.size(); ++i) {
      values[2 * i] = finite_double(ring[i].x);
      values[2 * i + 1] = finite_double(ring[i].y);
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
