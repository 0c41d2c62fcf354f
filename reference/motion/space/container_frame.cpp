// The outside of a container as an obstacle, and the scales at which a part fits there.
#include "reference/motion/space/container_frame.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "reference/error.hpp"
#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/swept_pieces.hpp"
#include "reference/motion/space/valid_scales.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

Polyhedron box_surface(const SpacePoint& a, const SpacePoint& b) {
  return {{a,
           {b.x, a.y, a.z},
           {b.x, b.y, a.z},
           {a.x, b.y, a.z},
           {a.x, a.y, b.z},
           {b.x, a.y, b.z},
           b,
           {a.x, b.y, b.z}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

}  // namespace

ExactSpaceBox::ExactSpaceBox(const std::vector<SpacePoint>& points)
    : low(points[0]), high(points[0]) {
  for (const SpacePoint& p : points) add(p);
}

void ExactSpaceBox::add(const SpacePoint& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void refuse_bad_fit(const Polyhedron& part, const Polyhedron& container) {
  if (is_thin(container)) {
    throw BadInput("degenerate-operands", "the container is without volume", "name a polyhedron");
  }
  if (part.vertices.size() < 2) {
    throw BadInput("point-part", "the part has no extent, so no scale is the largest",
                   "name a segment, a plane polygon or a polyhedron");
  }
}

SpaceFrame::SpaceFrame(const Polyhedron& part, const Polyhedron& container,
                       const std::vector<SpacePoint>& about) {
  refuse_bad_fit(part, container);
  const ExactSpaceBox inner(container.vertices), own(part.vertices);
  const SpacePoint room = inner.high - inner.low, size = own.high - own.low;
  std::optional<Rational> most;
  for (const auto& [in, needed] :
       {std::pair(room.x, size.x), std::pair(room.y, size.y), std::pair(room.z, size.z)}) {
    if (needed != 0 && (!most || in / needed < *most)) most = in / needed;
  }
  window.to = 2 * *most;
  const Rational margin = *window.to * (size.x + size.y + size.z) + room.x + room.y + room.z;
  ExactSpaceBox outer = inner;
  for (const SpacePoint& at : about) {
    for (const SpacePoint& p : {own.low, own.high}) outer.add(at + *window.to * p);
    outer.add(at);
  }
  set = container;
  for (Face& face : set.faces) std::reverse(face.begin(), face.end());
  const auto before = static_cast<std::uint32_t>(set.vertices.size());
  const SpacePoint wide{margin, margin, margin};
  const Polyhedron box = box_surface(outer.low - wide, outer.high + wide);
  set.vertices.insert(set.vertices.end(), box.vertices.begin(), box.vertices.end());
  for (const Face& face : box.faces) {
    for (std::uint32_t& v : set.faces.emplace_back(face)) v += before;
  }
}

SpaceFit scales_that_fit_at(const Polyhedron& part, const Polyhedron& container,
                            const SpacePoint& at, ContactRule rule) {
  const FloatEnvironment standard;
  const SpaceFrame frame(part, container, {at});
  const std::vector<SpacePoint> path{at};
  SpaceFit result{valid_scales(part, frame.set, path, rule, frame.window), {}};
  SweptPieces swept(part, frame.set, path, rule);
  const auto prove = [&](const Rational& scale) {
    const auto& valid = result.scales.valid;
    const bool holds = !swept.collide(scale);
    if (holds != std::any_of(valid.begin(), valid.end(),
                             [&](const ScaleRange& range) { return range.holds(scale); })) {
      throw std::logic_error("the place at " + to_string(scale) + " gives another answer");
    }
    result.proofs.push_back({scale, holds});
  };
  const auto& bounds = result.scales.bounds;
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const Rational& scale = bounds[k].scale;
    if (k > 0 && bounds[k - 1].scale == scale) continue;  // a single scale
    Rational hair = scale / (1 << 20);
    for (const SpacePathBound& other : bounds) {
      const Rational apart = abs(other.scale - scale) / 2;
      if (apart != 0) hair = std::min(hair, apart);
    }
    for (const Rational& one : {Rational(scale - hair), scale, Rational(scale + hair)}) prove(one);
  }
  return result;
}

}  // namespace minkref::inline space
