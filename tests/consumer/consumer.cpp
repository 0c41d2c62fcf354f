// The sum of two unit squares at scale 3 is a square of side 4, by every route of the installed
// library.
#include <iostream>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/sum.hpp"

int main() {
  const minkref::PolygonSet square{{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}}};
  for (const auto route :
       {minkref::Route::paper, minkref::Route::winding, minkref::Route::definition}) {
    const auto sum = minkref::minkowski_sum(square, square, 3, route);
    const auto text = minkref::canonical_json(sum.region);
    std::cout << text << "\n";
    if (text !=
        R"({"polygons":[{"holes":[],"outer":[["0","0"],["4","0"],["4","4"],["0","4"]]}]})") {
      return 1;
    }
  }
  return 0;
}
