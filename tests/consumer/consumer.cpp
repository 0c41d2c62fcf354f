// The sum of two unit squares at scale 3 is a 4 by 4 square, for every route of the installed
// library; and a unit square may double on its way through a gap, 2 wide.
#include <iostream>

#include "reference/minkref.hpp"

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
  const auto wall = [](int x) -> minkref::Polygon {
    return {{{x, 0}, {x + 5, 0}, {x + 5, 1}, {x, 1}}, {}};
  };
  const minkref::PolygonSet walls{{wall(-5), wall(2)}};
  const auto found = minkref::valid_scales(square, walls, {{0, 3}, {0, -3}});
  if (found.valid.size() != 1 || !found.valid[0].to || found.valid[0].to->scale != 2 ||
      !found.valid[0].to_in() || found.bounds.size() != 1 || !found.bounds[0].blocks) {
    return 2;
  }
  const minkref::ScaleWindow window{std::nullopt, minkref::Rational(3)};
  const auto diagram = minkref::path_diagram(square, walls, {{0, 3}, {0, -3}},
                                             minkref::ContactRule::allowed, window, 100);
  std::cout << diagram.polygons.size() << " bad polygons\n";
  return diagram.polygons.empty() ? 3 : 0;
}
