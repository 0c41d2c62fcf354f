#include "reference/motion/space/free/fits_and_traps.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/motion/held_scales.hpp"
#include "reference/motion/space/container_frame.hpp"
#include "reference/motion/space/free/face_planes.hpp"
#include "reference/motion/space/free/fit_routes.hpp"
#include "reference/motion/space/free/free_turn.hpp"
#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/swept_pieces.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

const Rational hair(1, 1 << 20);

/// Answers whether a place is free with contact allowed.
IsFree freedom(const Polyhedron& part, const Polyhedron& obstacles) {
  return [&part, &obstacles](const Rational& scale, const SpacePoint& place) {
    return !SweptPieces(part, obstacles, {place}, ContactRule::allowed).collide(scale);
  };
}

bool sees_all_strictly(const Polyhedron& part) {
  const std::vector<FacePlane> planes = face_planes(part);
  return !is_thin(part) && std::all_of(planes.begin(), planes.end(),
                                       [](const FacePlane& plane) { return plane.offset > 0; });
}

SpaceFreeScales fit_by_events(const Polyhedron& part, const Polyhedron& container,
                              ContactRule rule) {
  if (!has_inner_centre(part)) {
    throw BadInput("not-star-shaped",
                   "no point strictly inside the part sees all of it, and the container is not "
                   "convex",
                   "ask for a place (--at X,Y,Z), give a convex container, or a part that is "
                   "star-shaped about a point inside");
  }
  const SpaceFrame frame(part, container, {});
  const Polyhedron turned = half_turned(part);
  const FreeTurn fits(turned, frame.set, has_bounded_free_places);
  const auto [low, high] = fits.bracket(*frame.window.to);
  const FreeEvents events(turned, frame.set, low, high);
  const auto turn = fits.find(events, low, high, true, freedom(part, frame.set));
  if (!turn) throw std::logic_error("the last free places vanish without an event");
  const FoundTurn& found = *turn;
  const Rational& greatest = found.scale;
  SpaceFreeScales result;
  const bool allowed = rule == ContactRule::allowed;
  result.scales = {{{0, true}, ScaleCut{greatest, allowed}}};
  result.critical_scales = events.scales().size();
  const SpaceFit there = scales_that_fit_at(part, container, found.at);
  const auto& bounds = there.scales.bounds;
  const auto last = std::find_if(bounds.begin(), bounds.end(), [&](const SpacePathBound& bound) {
    return bound.blocks && bound.scale == greatest;
  });
  if (last == bounds.end() || there.scales.valid.back().to != ScaleCut{greatest, true}) {
    throw std::logic_error("the part at its last place fits at other scales");
  }
  result.bounds.push_back({greatest, true, "death", found.at, *last});
  for (const auto& [scale, holds] : found.proofs) result.proofs.push_back({scale, holds});
  result.proofs.insert(result.proofs.begin() + 1, {greatest, allowed});
  return result;
}

/// Drops what lies outside a window, and the bounds that end no range any more.
SpaceFreeScales within(SpaceFreeScales found, const ScaleWindow& window) {
  found.scales = scales_without(found.scales, {}, window);
  std::erase_if(found.bounds, [&](const SpaceFreeBound& bound) {
    return std::none_of(found.scales.begin(), found.scales.end(), [&](const ScaleRange& range) {
      return bound.ends ? range.to && range.to->scale == bound.scale
                        : range.from.scale == bound.scale;
    });
  });
  return found;
}

}  // namespace

SpaceFreeScales scales_that_fit(const Polyhedron& part, const Polyhedron& container,
                                ContactRule rule) {
  const FloatEnvironment standard;
  refuse_bad_fit(part, container);
  return is_convex(container) ? fit_into_convex(part, container, rule)
                              : fit_by_events(part, container, rule);
}

SpaceFreeScales trapped_scales(const Polyhedron& part, const Polyhedron& obstacles,
                               const SpacePoint& at, ContactRule rule, const ScaleWindow& window) {
  const FloatEnvironment standard;
  refuse_bad_window(window);
  if (part.empty() || obstacles.empty()) return {};
  if (is_thin(obstacles)) {
    throw BadInput("degenerate-operands", "the obstacles are without volume", "name a polyhedron");
  }
  if (!sees_all_strictly(part)) {
    throw BadInput("not-star-shaped",
                   "the part's origin does not lie strictly below the planes of all its faces, and "
                   "a smaller part then may have less room",
                   "give a part that is star-shaped about its origin, with the origin strictly "
                   "inside; `minkref hold` takes any part, for a given way");
  }
  const SpaceValidScales free = valid_scales(part, obstacles, {at}, rule);
  if (free.valid.empty()) return {};
  const SpacePathBound& last = free.bounds.at(0);
  const bool allowed = rule == ContactRule::allowed;
  const Polyhedron turned = half_turned(part);
  SpaceFreeScales result;
  const FreeTurn escapes(turned, obstacles,
                         [&](const FreeProblemAt& problem) { return !is_enclosed(problem, at); });
  const auto answer = [&](const ScaleCut& from) {
    result.scales = {{from, ScaleCut{last.scale, allowed}}};
    result.bounds.push_back({last.scale, true, "contact", last.touching, last});
    const Rational below =
        std::max<Rational>((from.scale + last.scale) / 2, last.scale - hair * last.scale);
    if (escapes.is_small(below, FreeRoute::edges)) throw std::logic_error("a way out of a trap");
    result.proofs.push_back({below, true});
    SweptPieces swept(part, obstacles, {at}, rule);
    for (const auto& [scale, holds] :
         {std::pair(last.scale, allowed),
          std::pair(Rational(last.scale + hair * last.scale), false)}) {
      if (swept.collide(scale) == holds) {
        throw std::logic_error("pieces give another answer at " + to_string(scale));
      }
      result.proofs.push_back({scale, holds});
    }
    return within(std::move(result), window);
  };
  const Polyhedron origin{{SpacePoint{}}, {}};
  if (is_enclosed({origin, obstacles, 1}, at)) return answer({0, true});  // a closed room
  Rational low = last.scale * (1 - hair), high = last.scale;
  const bool is_narrow = escapes.is_small(low);
  if (!is_narrow) std::tie(low, high) = escapes.bracket(low);
  const FreeEvents events(turned, obstacles, low, high);
  result.critical_scales = events.scales().size();
  const auto found = escapes.find(events, low, high, !is_narrow, freedom(part, obstacles));
  if (!found) return result;
  for (const auto& [scale, small] : found->proofs) result.proofs.push_back({scale, !small});
  result.proofs.insert(result.proofs.begin() + 1, {found->scale, !allowed});
  result.bounds.push_back({found->scale, false, "split", found->at, {}});
  return answer({found->scale, allowed});
}

}  // namespace minkref::inline space
