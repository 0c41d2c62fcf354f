// CGAL, Minkowski sum of two polygons: vertical.
// cgal-vertical-raw crashed: crashed
//
// g++ -std=c++17 -O2 -DNDEBUG -frounding-math cgal_hole_filter.cpp -o cgal_hole_filter -lmpfr -lgmp && ./cgal_hole_filter
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using Text = std::vector<std::vector<std::vector<const char*>>>;  // outer ring, holes; x, y

// clang-format off
const Text kP = {
    {{"0", "0"}, {"6", "0"}, {"2", "5"}},
    {{"2", "3"}, {"1", "1"}, {"1", "2"}},
    {{"3", "2"}, {"5", "1"}, {"4", "1"}},
    {{"2", "2"}, {"3", "1"}, {"2", "1"}}};

const Text kQ = {
    {{"1", "0"}, {"0", "2"}, {"0", "0"}}};
// clang-format on

Number integer(const std::string& text) {
  Number value = 0;
  for (const char c : text) {
    if (c != '-') value = value * 10 + (c - '0');
  }
  return text[0] == '-' ? Number(-value) : value;
}

// "n" or "n/d", exactly.
Number number(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return integer(text);
  const Number value = integer(text.substr(0, slash)) / integer(text.substr(slash + 1));
  CGAL::exact(value);  // the tightest interval of doubles around it
  return value;
}

// sign * p + shift for each vertex p; a point reflection keeps the orientation.
PolygonWithHoles polygon(const Text& text, int sign, const Number& dx, const Number& dy) {
  PolygonWithHoles result;
  for (const auto& vertices : text) {
    Polygon ring;
    for (const auto& p : vertices) {
      ring.push_back(Point(sign * number(p[0]) + dx, sign * number(p[1]) + dy));
    }
    if (result.outer_boundary().is_empty()) {
      result.outer_boundary() = ring;
    } else {
      result.add_hole(ring);
    }
  }
  return result;
}

int main() {
  const PolygonWithHoles givenP = polygon(kP, 1, 0, 0), givenQ = polygon(kQ, 1, 0, 0);
  const auto& P = givenP;
  const auto& Q = givenQ.outer_boundary();
  const PolygonWithHoles sum = CGAL::minkowski_sum_2(P, Q, CGAL::Polygon_vertical_decomposition_2<Kernel>());
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ", vertical: " << sum.outer_boundary().size()
            << " vertices outside, " << sum.number_of_holes() << " holes" << std::endl;
  return 0;
}
