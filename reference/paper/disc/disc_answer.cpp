#include "reference/paper/disc/disc_answer.hpp"

#include <algorithm>
#include <cmath>

namespace minkref::inline disc {

std::optional<double> corner_distance(const DiscAnswer& a, const DiscAnswer& b) {
  if (a.rings.size() != b.rings.size()) return std::nullopt;
  double most = 0;
  for (std::size_t k = 0; k < a.rings.size(); ++k) {
    if (a.rings[k].size() != b.rings[k].size()) return std::nullopt;
    for (std::size_t i = 0; i < a.rings[k].size(); ++i) {
      const DiscAnswer::Piece &x = a.rings[k][i], &y = b.rings[k][i];
      if (x.is_arc != y.is_arc || x.centre_x != y.centre_x || x.centre_y != y.centre_y) {
        return std::nullopt;
      }
      const double off = std::hypot(x.from_x - y.from_x, x.from_y - y.from_y);
      if (!(off <= most)) most = off;
    }
  }
  return most;
}

}  // namespace minkref::inline disc
