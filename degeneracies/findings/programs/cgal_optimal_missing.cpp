// CGAL, Minkowski sum of two polygons: optimal.
// cgal-optimal wrong: missing
//
// g++ -std=c++17 -O2 -DNDEBUG -frounding-math cgal_optimal_missing.cpp -o cgal_optimal_missing -lmpfr -lgmp && ./cgal_optimal_missing
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
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
    {{"1", "0"}, {"1", "1"}, {"2", "0"}, {"3", "0"}, {"2", "1"}, {"1", "3"}, {"1", "2"},
     {"0", "0"}}};

const Text kQ = {
    {{"1", "1"}, {"0", "0"}, {"1", "0"}}};
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

// Outside the outer ring, or strictly inside a hole: no. (Rings may touch themselves.)
bool covers(const PolygonWithHoles& set, const Point& x) {
  const auto side = [&](const Polygon& ring) {
    return CGAL::bounded_side_2(ring.vertices_begin(), ring.vertices_end(), x, Kernel());
  };
  if (side(set.outer_boundary()) == CGAL::ON_UNBOUNDED_SIDE) return false;
  for (auto hole = set.holes_begin(); hole != set.holes_end(); ++hole) {
    if (side(*hole) == CGAL::ON_BOUNDED_SIDE) return false;
  }
  return true;
}

int main() {
  const PolygonWithHoles givenP = polygon(kP, 1, 0, 0), givenQ = polygon(kQ, 1, 0, 0);
  const auto& P = givenP.outer_boundary();
  const auto& Q = givenQ.outer_boundary();
  const PolygonWithHoles sum = CGAL::minkowski_sum_2(P, Q, CGAL::Optimal_convex_decomposition_2<Kernel>());
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ", optimal: " << sum.outer_boundary().size()
            << " vertices outside, " << sum.number_of_holes() << " holes" << std::endl;
  const Point x(number("2"), number("2"));
  const bool truth = true;
  const bool in = covers(sum, x);
  std::cout << "x = (2, 2) in this sum: " << (in ? "in" : "out") << std::endl
            << "in truth: " << (truth ? "in" : "out") << std::endl;
  // Independently: x lies inside the sum where the interiors of P and x - Q meet, else outside or
  // on its boundary.
  const bool meet = CGAL::do_intersect(givenP, polygon(kQ, -1, x.x(), x.y()));
  std::cout << "interiors of P and x - Q, by CGAL's Boolean operations: "
            << (meet ? "they meet" : "disjoint") << std::endl;
  return in == truth ? 0 : 1;
}
