// The greatest scale at which a part fits into a convex container, by a linear program.
#include <algorithm>
#include <stdexcept>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/motion/space/container_frame.hpp"
#include "reference/motion/space/free/face_planes.hpp"
#include "reference/motion/space/free/fit_routes.hpp"
#include "reference/motion/space/free/greatest_scale.hpp"
#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/swept_pieces.hpp"
#include "reference/motion/space/touching_features.hpp"

namespace minkref::inline space {
namespace {

Rational one_norm(const SpacePoint& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

std::size_t axis_with_width(const SpacePoint& size) {
  return size.x != 0 ? 0 : size.y != 0 ? 1 : 2;
}

/// The vertex farthest along a direction.
std::uint32_t farthest(const Polyhedron& part, const SpacePoint& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t k = 1; k < part.vertices.size(); ++k) {
    if (dot(direction, part.vertices[k] - part.vertices[best]) > 0) best = k;
  }
  return best;
}

SpacePoint mean_of(const std::vector<SpacePoint>& points) {
  SpacePoint sum;
  for (const SpacePoint& p : points) sum = sum + p;
  return Rational(1, static_cast<long>(points.size())) * sum;
}

}  // namespace

bool is_convex(const Polyhedron& polyhedron) {
  if (!polyhedron.is_solid() || is_thin(polyhedron)) return false;
  for (const FacePlane& plane : face_planes(polyhedron)) {
    look_for_interrupt();
    for (const SpacePoint& v : polyhedron.vertices) {
      if (dot(plane.normal, v) > plane.offset) return false;
    }
  }
  return true;
}

bool has_inner_centre(const Polyhedron& part) {
  if (is_thin(part)) return false;
  std::vector<ScaleCondition> conditions;  // a cube of the half-width s lies below all planes
  for (const FacePlane& plane : face_planes(part)) {
    conditions.push_back({plane.normal, one_norm(plane.normal), plane.offset});
  }
  const ExactSpaceBox box(part.vertices);
  const SpacePoint unit{1, 1, 1};
  return greatest_scale(conditions, box_conditions(0, {-1, -1, -1}, unit, box.low, box.high))
             .scale > 0;
}

SpaceFreeScales fit_into_convex(const Polyhedron& part, const Polyhedron& container,
                                ContactRule rule) {
  std::vector<ScaleCondition> conditions;
  std::vector<std::uint32_t> touching;
  for (const FacePlane& plane : face_planes(container)) {
    look_for_interrupt();
    touching.push_back(farthest(part, plane.normal));
    conditions.push_back(
        {plane.normal, dot(plane.normal, part.vertices[touching.back()]), plane.offset});
  }
  const ExactSpaceBox own(part.vertices), room(container.vertices);
  const GreatestScale found = greatest_scale(
      conditions,
      box_conditions(axis_with_width(own.high - own.low), own.low, own.high, room.low, room.high));
  if (found.is_by_start) throw std::logic_error("a box around the container is too narrow");
  const bool allowed = rule == ContactRule::allowed;
  SpaceFreeScales result;
  result.scales = {{{0, true}, ScaleCut{found.scale, allowed}}};
  for (const auto& [face, weight] : found.weights) {
    result.supports.push_back({touching[face], static_cast<std::uint32_t>(face), weight});
  }
  const FitSupport& first = result.supports[0];
  const SpacePoint at = found.at + found.scale * part.vertices[first.vertex];
  const auto touched = feature_at(container, at);
  if (!touched) throw std::logic_error("the part touches no face of its convex container");
  const SpaceFeature vertex{SpaceFeature::Kind::vertex, first.vertex, 0};
  result.bounds.push_back(
      {found.scale, true, "contact", found.at,
       SpacePathBound{found.scale, true, {0, 0, found.at}, vertex, *touched, at}});
  // Just below, all of the part's points move towards the container's middle.
  const SpaceFrame frame(part, container, {found.at});
  const Rational share = 1 - Rational(1, 1 << 20);
  const SpacePoint below = share * found.at + (1 - share) * mean_of(container.vertices);
  for (const auto& [scale, place, holds] : {std::tuple(Rational(share * found.scale), below, true),
                                            std::tuple(found.scale, found.at, allowed)}) {
    if (SweptPieces(part, frame.set, {place}, rule).collide(scale) == holds) {
      throw std::logic_error("pieces give another answer at " + to_string(scale));
    }
    result.proofs.push_back({scale, holds});
  }
  result.proofs.push_back({found.scale * (1 + Rational(1, 1 << 20)), false});  // by the weights
  return result;
}

}  // namespace minkref::inline space
