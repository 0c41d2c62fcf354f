// CGAL: approximated_offset_2, epsilon RADIUS / 2000, then a set for Boolean operations.
// Usage: ./cgal_offset "X Y" TRUTH P RADIUS, TRUTH being in, out or any (crashes).
// P, as CGAL reads it: vertex count, coordinates, hole count, holes likewise.
#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>
#include <CGAL/version.h>

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;

template <class Value>
Value read(const std::string& text) {
  std::istringstream stream(text + "\n");
  Value value;
  if (!(stream >> value)) throw std::runtime_error("cannot read " + text);
  return value;
}

int main(int, char** argv) {
  const auto x = read<Kernel::Point_2>(argv[1]);
  const std::string truth = argv[2];
  const auto radius = read<Kernel::FT>(argv[4]);
  const auto P = read<CGAL::Polygon_with_holes_2<Kernel>>(argv[3]);
  const auto grown = CGAL::approximated_offset_2(P, radius, CGAL::to_double(radius) / 2000);
  Traits traits;
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ": " << grown.number_of_holes()
            << " holes, valid: " << CGAL::is_valid_polygon_with_holes(grown, traits) << std::endl;
  CGAL::General_polygon_set_2<Traits> set;
  set.join(grown);
  const auto side = set.oriented_side(Traits::Point_2(x.x(), x.y()));
  const std::string found = side == CGAL::ON_NEGATIVE_SIDE ? "out" : "in";
  std::cout << "x = (" << argv[1] << ") in the offset: " << found << ", in truth: " << truth
            << std::endl;
  return truth == "any" || truth == found ? 0 : 1;
}
