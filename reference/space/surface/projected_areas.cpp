#include "reference/space/surface/projected_areas.hpp"

#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/number/balanced_sum.hpp"

namespace minkref::inline space {

std::array<Rational, 3> projected_areas(const PolyhedralSet& set) {
  std::array<std::vector<Rational>, 3> terms;
  for (const PlaneRegion& face : set.faces) {
    look_for_interrupt();
    const IntegerVector& n = face.plane.normal;
    const Rational unit = area(face.region) / Rational(abs(n[viewing_axis(n)]));
    for (std::size_t k = 0; k < 3; ++k) terms[k].push_back(unit * Rational(abs(n[k])));
  }
  return {balanced_sum(std::move(terms[0])), balanced_sum(std::move(terms[1])),
          balanced_sum(std::move(terms[2]))};
}

}  // namespace minkref::inline space
