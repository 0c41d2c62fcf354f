// SPDX-License-Identifier: GPL-3.0-or-later
// Input and output: one polygon with holes, exact coordinates, no CGAL.
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

/// The operand is not what the protocol asks for (a fault of the caller's).
struct BadOperand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number "n" or "n/d". `name` stands in the message of the BadOperand that it throws.
mpq_class read_number(const nlohmann::json& value, const std::string& name);

/// Reads {"polygons":[{"outer":[["x","y"],...],"holes":[...]},...]}, numbers as strings "n" or
/// "n/d". Exact. `name` stands in the message of the BadOperand that it throws.
std::vector<Polygon> read_polygons(const nlohmann::json& value, const std::string& name);

/// The same form, every number in lowest terms, rings and vertices in the order given.
nlohmann::json write_polygons(const std::vector<Polygon>& polygons);

}  // namespace minkref::cgal_oracle
