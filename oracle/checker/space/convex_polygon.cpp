#include "oracle/checker/space/convex_polygon.hpp"

namespace minkref::checker {

std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, const HalfSpace& half,
                                   Budget& budget) {
  budget.spend(polygon.size());
  const auto& [normal, height] = half;
  std::vector<mpz_class> levels;
  bool rises = false, sinks = false;
  for (const Corner& p : polygon) {
    mpz_class level = normal[0] * p[0];
    level += normal[1] * p[1];
    level += normal[2] * p[2];
    level -= height * p[3];
    rises = rises || level > 0;
    sinks = sinks || level < 0;
    levels.push_back(std::move(level));
  }
  if (!rises) return std::nullopt;
  ConvexPolygon kept;
  if (!sinks) return kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t before = (k + polygon.size() - 1) % polygon.size();
    if (sgn(levels[before]) * sgn(levels[k]) < 0) {
      Corner point;
      mpz_class divisor;
      for (std::size_t c = 0; c < 4; ++c) {
        point[c] = abs(levels[k]) * polygon[before][c] + abs(levels[before]) * polygon[k][c];
        divisor = gcd(divisor, point[c]);
      }
      for (mpz_class& c : point) c /= divisor;
      kept.push_back(std::move(point));
    }
    if (levels[k] <= 0) kept.push_back(polygon[k]);
  }
  return kept;
}

}  // namespace minkref::checker
