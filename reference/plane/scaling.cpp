#include "reference/plane/scaling.hpp"

#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

void stretch(Ring& ring, const PlaneScaling& by) {
  for (Point& point : ring) {
    look_for_interrupt();
    point.x *= by.x;
    point.y *= by.y;
  }
}

}  // namespace

void require_positive(const PlaneScaling& scaling) {
  for (const Rational* factor : {&scaling.x, &scaling.y}) {
    if (sign(*factor) > 0) continue;
    throw BadInput("bad-scale", "the factor " + to_string(*factor) + " is not greater than zero",
                   "give two factors above 0, one for each axis");
  }
}

PolygonSet scaled(const PolygonSet& set, const PlaneScaling& scaling) {
  require_positive(scaling);
  PolygonSet image = set;
  for (Polygon& polygon : image.polygons) {
    stretch(polygon.outer, scaling);
    for (Ring& hole : polygon.holes) stretch(hole, scaling);
  }
  return image;
}

}  // namespace minkref::inline plane
