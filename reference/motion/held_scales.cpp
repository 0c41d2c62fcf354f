#include "reference/motion/held_scales.hpp"

#include "reference/motion/routes.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline motion {

std::vector<ScaleRange> scales_without(const std::vector<ScaleRange>& all,
                                       const std::vector<ScaleRange>& some,
                                       const ScaleWindow& window) {
  ScaleSet kept, removed;
  for (const ScaleRange& range : all) kept.add(range.from, range.to);
  for (const ScaleRange& range : kept.left_of(window)) removed.add(range.from, range.to);
  for (const ScaleRange& range : some) removed.add(range.from, range.to);
  return removed.left_of(window);
}

HeldScales held_scales(const PolygonSet& part, const PolygonSet& obstacles,
                       const std::vector<Point>& way, ContactRule rule, const ScaleWindow& window,
                       PathRoute route) {
  const FloatEnvironment standard;
  refuse_bad_problem(part, obstacles, way, window);
  return held_of(valid_scales(part, obstacles, {way[0]}, rule, window, route),
                 valid_scales(part, obstacles, way, rule, window, route), window,
                 [&](const std::vector<Rational>& scales) {
                   return stops_of({part, obstacles, way, rule, window}, scales);
                 });
}

}  // namespace minkref::inline motion
