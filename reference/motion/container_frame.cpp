#include "reference/motion/container_frame.hpp"

#include "reference/error.hpp"

namespace minkref::inline motion {
namespace {

void refuse_bad_fit(const PolygonSet& part, const PolygonSet& container) {
  if (!container.is_region()) {
    throw BadInput("degenerate-operands", "the container is without area",
                   "name a set of polygons");
  }
  if (part.empty() || part.is_point()) {
    throw BadInput("point-part", "the part has no extent, so no scale is the largest",
                   "name a segment or a set of polygons");
  }
}

ScaleWindow window_of_fits(const PolygonSet& part, const PolygonSet& container) {
  refuse_bad_fit(part, container);
  const ExactBox inner(container), own(part);
  std::optional<Rational> most;
  const auto room = [&](const Rational& in, const Rational& needed) {
    if (needed != 0 && (!most || in / needed < *most)) most = in / needed;
  };
  room(inner.width(), own.width());
  room(inner.height(), own.height());
  ScaleWindow window;
  window.to = 2 * *most;
  return window;
}

Outside outside_with_room(const PolygonSet& part, const PolygonSet& container,
                          const std::vector<Point>& about, const Rational& largest) {
  const ExactBox inner(container), own(part);
  // More than the part at all scales of the window, on all sides; and the part at its places.
  const Rational margin = largest * (own.width() + own.height()) + inner.width() + inner.height();
  ExactBox outer = inner;
  for (const Point& x : about) {
    for (const Point& p : {own.low, own.high}) {
      outer.add({x.x + largest * p.x, x.y + largest * p.y});
      outer.add(x);
    }
  }
  return {container,
          {outer.low.x - margin, outer.low.y - margin},
          {outer.high.x + margin, outer.high.y + margin}};
}

}  // namespace

ContainerFrame::ContainerFrame(const PolygonSet& part, const PolygonSet& container,
                               const std::vector<Point>& about)
    : window(window_of_fits(part, container)),
      outside(outside_with_room(part, container, about, *window.to)) {}

TouchingFeature ContainerFrame::in_container(const TouchingFeature& feature) const {
  return {feature.is_edge,
          feature.is_edge ? outside.edge_of_P(feature.id) : outside.vertex_of_P(feature.id)};
}

}  // namespace minkref::inline motion
