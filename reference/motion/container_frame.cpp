#include "reference/motion/container_frame.hpp"

#include <algorithm>

#include "reference/error.hpp"

namespace minkref::inline motion {
namespace {

struct ExactBox {
  Point low, high;
  explicit ExactBox(const Point& p) : low(p), high(p) {}
  void add(const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Rational width() const { return high.x - low.x; }
  Rational height() const { return high.y - low.y; }
};

ExactBox box_of(const PolygonSet& set) {
  ExactBox box(set.polygons[0].outer[0]);
  for (const Polygon& polygon : set.polygons) {
    for (const Point& p : polygon.outer) box.add(p);
  }
  return box;
}

}  // namespace

ContainerFrame::ContainerFrame(const PolygonSet& part, const PolygonSet& container,
                               const std::vector<Point>& about) {
  if (!container.is_region()) {
    throw BadInput("degenerate-operands", "the container is without area",
                   "name a set of polygons");
  }
  if (part.empty() || part.is_point()) {
    throw BadInput("point-part", "the part has no extent, so no scale is the largest",
                   "name a segment or a set of polygons");
  }
  const ExactBox inner = box_of(container), own = box_of(part);
  std::optional<Rational> most;
  const auto room = [&](const Rational& in, const Rational& needed) {
    if (needed != 0 && (!most || in / needed < *most)) most = in / needed;
  };
  room(inner.width(), own.width());
  room(inner.height(), own.height());
  window.to = 2 * *most;
  // More than the part at all scales of the window, on all sides; and the part at its places.
  const Rational margin =
      *window.to * (own.width() + own.height()) + inner.width() + inner.height();
  ExactBox outer = inner;
  for (const Point& x : about) {
    for (const Point& p : {own.low, own.high}) {
      outer.add({x.x + *window.to * p.x, x.y + *window.to * p.y});
      outer.add(x);
    }
  }
  const Point low{outer.low.x - margin, outer.low.y - margin},
      high{outer.high.x + margin, outer.high.y + margin};
  set.polygons.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  rings_.emplace_back(0, 4);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> islands;
  std::uint32_t ring = 0;
  const auto backwards = [](const Ring& r) { return Ring(r.rbegin(), r.rend()); };
  for (const Polygon& polygon : container.polygons) {
    set.polygons[0].holes.push_back(backwards(polygon.outer));
    rings_.emplace_back(ring++, static_cast<std::uint32_t>(polygon.outer.size()));
    for (const Ring& hole : polygon.holes) {
      set.polygons.push_back({backwards(hole), {}});
      islands.emplace_back(ring++, static_cast<std::uint32_t>(hole.size()));
    }
  }
  rings_.insert(rings_.end(), islands.begin(), islands.end());
}

TouchingFeature ContainerFrame::in_container(const TouchingFeature& feature) const {
  const auto [ring, size] = rings_.at(feature.id.ring);
  // Rings run backwards: the edge from i to i + 1 is the one from the other's i + 1 to i.
  const std::uint32_t i = feature.id.index, last = size - 1;
  return {feature.is_edge, {ring, feature.is_edge ? (2 * last - i) % size : last - i}};
}

}  // namespace minkref::inline motion
