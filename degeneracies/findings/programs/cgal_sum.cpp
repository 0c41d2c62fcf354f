// CGAL: Minkowski sums of polygons.
// Usage: ./cgal_sum "X Y" TRUTH P Q METHOD, TRUTH being in, out or any (crashes).
// Operands, as CGAL reads them: vertex count, coordinates, hole count, holes likewise.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;
using Set = CGAL::Polygon_with_holes_2<Kernel>;

template <class Value>
Value read(const std::string& text) {
  std::istringstream stream(text + "\n");
  Value value;
  if (!(stream >> value)) throw std::runtime_error("cannot read " + text);
  return value;
}

Set sum_of(const Set& P, const Set& Q, const std::string& method) {
  const Ring &p = P.outer_boundary(), &q = Q.outer_boundary();
  if (method == "reduced") return CGAL::minkowski_sum_by_reduced_convolution_2(P, Q);
  if (method == "full") return CGAL::minkowski_sum_by_full_convolution_2(p, q);
  if (method == "vertical") {
    return CGAL::minkowski_sum_2(P, Q, CGAL::Polygon_vertical_decomposition_2<Kernel>());
  }
  if (method == "optimal") {
    return CGAL::minkowski_sum_2(p, q, CGAL::Optimal_convex_decomposition_2<Kernel>());
  }
  throw std::runtime_error("no method " + method);
}

// Closed: boundaries belong.
bool covers(const Set& set, const Kernel::Point_2& x) {
  const auto side = [&](const Ring& ring) {
    return CGAL::bounded_side_2(ring.vertices_begin(), ring.vertices_end(), x, Kernel());
  };
  bool in = side(set.outer_boundary()) != CGAL::ON_UNBOUNDED_SIDE;
  for (const Ring& hole : set.holes()) in = in && side(hole) != CGAL::ON_BOUNDED_SIDE;
  return in;
}

int main(int, char** argv) {
  const auto x = read<Kernel::Point_2>(argv[1]);
  const std::string truth = argv[2], method = argv[5];
  const Set sum = sum_of(read<Set>(argv[3]), read<Set>(argv[4]), method);
  const std::string found = covers(sum, x) ? "in" : "out";
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ", " << method << ": "
            << sum.outer_boundary().size() << " vertices outside, " << sum.number_of_holes()
            << " holes\nx = (" << argv[1] << ") in this sum: " << found << ", in truth: " << truth
            << std::endl;
  return truth == "any" || truth == found ? 0 : 1;
}
