#include "reference/motion/space/held_scales.hpp"

#include "reference/number/float_environment.hpp"

namespace minkref::inline space {

SpaceHeldScales held_scales(const Polyhedron& part, const Polyhedron& obstacles,
                            const std::vector<SpacePoint>& way, ContactRule rule,
                            const ScaleWindow& window, PathRoute route) {
  const FloatEnvironment standard;
  SpaceValidScales of_way = valid_scales(part, obstacles, way, rule, window, route);
  return held_of(valid_scales(part, obstacles, {way[0]}, rule, window, route), std::move(of_way),
                 window, [&](const std::vector<Rational>& scales) {
                   return stops_of(part, obstacles, way, rule, scales);
                 });
}

}  // namespace minkref::inline space
