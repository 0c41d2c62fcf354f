// Points and scalings from space across Python's border.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <tuple>
#include <utility>

#include "bindings/exact_number.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref::python {

using ExactSpacePoint = std::tuple<std::string, std::string, std::string>;

/// Python's Polyhedron: the surface, and the places of its vertices and faces within the source
/// file.
struct Surface {
  MeshReading reading;

  explicit Surface(MeshReading from) : reading(std::move(from)) {}
  explicit Surface(Polyhedron polyhedron) { reading.polyhedron = std::move(polyhedron); }
  const Polyhedron& value() const { return reading.polyhedron; }
};

/// A row of three Python numbers; `where` names the row for a refusal.
ExactSpacePoint space_point_of(nanobind::handle row, const std::string& where);

inline ExactSpacePoint to_strings(const SpacePoint& point) {
  return {to_string(point.x), to_string(point.y), to_string(point.z)};
}

/// A point as numbers of Python.
inline ExactTriple exact_point(const SpacePoint& point) {
  return {{point.x}, {point.y}, {point.z}};
}

inline SpacePoint to_point(const ExactSpacePoint& coordinates) {
  const auto& [x, y, z] = coordinates;
  return {parse_rational(x), parse_rational(y), parse_rational(z)};
}

inline Scaling to_scaling(const ExactSpacePoint& factors) {
  const auto& [x, y, z] = factors;
  return {parse_rational(x), parse_rational(y), parse_rational(z)};
}

}  // namespace minkref::python
