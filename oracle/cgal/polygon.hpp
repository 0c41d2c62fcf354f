// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes polygons with holes, with exact coordinates, without CGAL.
#pragma once

#include <gmpxx.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace minkref::cgal_oracle {

struct Point {
  mpq_class x, y;
  friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const Point& a, const Point& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

using Ring = std::vector<Point>;

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// The operand breaks the protocol, through a fault of the caller.
struct BadOperand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a number "n" or "n/d". Throws BadOperand, naming `name`.
mpq_class read_number(const nlohmann::json& value, const std::string& name);

/// Reads {"polygons":[{"outer":[["x","y"],...],"holes":[...]},...]}, numbers as strings "n" or
/// "n/d". Exact. Throws BadOperand, naming `name`.
std::vector<Polygon> read_polygons(const nlohmann::json& value, const std::string& name);

/// Writes the same form, every number in lowest terms, rings and vertices in the given order.
nlohmann::json write_polygons(const std::vector<Polygon>& polygons);

}  // namespace minkref::cgal_oracle
