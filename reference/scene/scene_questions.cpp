#include "reference/scene/scene_questions.hpp"

#include <algorithm>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/motion/routes.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/set_operations.hpp"
#include "reference/scene/seam_growth.hpp"

namespace minkref::inline scene {
namespace {

std::vector<Point> points_of(const PolygonSet& set) {
  std::vector<Point> all;
  for (const Polygon& polygon : set.polygons)
    all.insert(all.end(), polygon.outer.begin(), polygon.outer.end());
  return all;
}

std::vector<Point> moved(std::vector<Point> path, const Point& by) {
  for (Point& p : path) p = {p.x - by.x, p.y - by.y};
  return path;
}

void refuse_empty(const std::vector<Point>& path) {
  if (path.empty()) throw BadInput("bad-path", "a way has at least one vertex", "give it one");
}

}  // namespace

SceneQuestions::ExactBox SceneQuestions::box_of(const std::vector<Point>& points) {
  ExactBox box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

SceneQuestions::ExactBox SceneQuestions::box_of(const PolygonSet& set) {
  const std::vector<Point> points = points_of(set);
  return points.empty() ? ExactBox{} : box_of(points);
}

SceneQuestions::SceneQuestions(Scene scene)
    : scene_(std::move(scene)),
      turned_robot_(half_turned(scene_.robot)),
      robot_box_(box_of(scene_.robot)) {
  refuse_without_area(scene_.robot, scene_.shapes);
  for (const Copy& copy : scene_.copies) refuse_bad_copy(copy, scene_.shapes.size());
  for (const PolygonSet& shape : scene_.shapes) {
    look_for_interrupt();
    turned_shapes_.push_back(half_turned(shape));
    shape_boxes_.push_back(box_of(shape));
  }
}

/// The least factor f >= 1 at which the copy's box, f times as large about its place, meets that of
/// the robot along the way; none if no factor does.
std::optional<Rational> SceneQuestions::first_factor(std::uint32_t copy,
                                                     const ExactBox& path) const {
  const Copy& c = scene_.copies[copy];
  const ExactBox& shape = shape_boxes_[c.shape];
  if (scene_.shapes[c.shape].empty() || scene_.robot.empty()) return std::nullopt;
  Rational factor = 1;
  // side * f >= reach
  const auto demand = [&](const Rational& side, const Rational& reach) {
    if (side > 0) {
      factor = std::max(factor, Rational(reach / side));
      return true;
    }
    return side >= reach;  // no larger factor helps
  };
  const bool meets = demand(c.scale * shape.high.x, path.low.x + robot_box_.low.x - c.place.x) &&
                     demand(-c.scale * shape.low.x, c.place.x - path.high.x - robot_box_.high.x) &&
                     demand(c.scale * shape.high.y, path.low.y + robot_box_.low.y - c.place.y) &&
                     demand(-c.scale * shape.low.y, c.place.y - path.high.y - robot_box_.high.y);
  return meets ? std::optional(factor) : std::nullopt;
}

bool SceneQuestions::may_meet(std::uint32_t copy, const ExactBox& path) const {
  const Copy& c = scene_.copies[copy];
  const ExactBox& shape = shape_boxes_[c.shape];
  if (scene_.shapes[c.shape].empty()) return false;
  const Rational& s = c.scale;
  return c.place.x + s * shape.high.x >= path.low.x + robot_box_.low.x &&
         c.place.x + s * shape.low.x <= path.high.x + robot_box_.high.x &&
         c.place.y + s * shape.high.y >= path.low.y + robot_box_.low.y &&
         c.place.y + s * shape.low.y <= path.high.y + robot_box_.high.y;
}

/// Scales of the copy at which the robot passes: with the roles changed, for x + R meets
/// place + s Shape iff x - place + s (-Shape) meets -R.
ValidScales SceneQuestions::scales(std::uint32_t copy, const std::vector<Point>& path,
                                   ContactRule rule, const ScaleWindow& window) const {
  const Copy& c = scene_.copies[copy];
  return valid_scales(turned_shapes_[c.shape], turned_robot_, moved(path, c.place), rule, window);
}

std::vector<Holder> SceneQuestions::holders(const Point& place) const {
  const FloatEnvironment standard;
  const ExactBox at{place, place};
  std::vector<Holder> result;
  for (std::uint32_t k = 0; k < scene_.copies.size(); ++k) {
    look_for_interrupt();
    if (!may_meet(k, at)) continue;
    const Copy& c = scene_.copies[k];
    const Membership membership(scene_.shapes[c.shape], turned_robot_, c.scale);
    const Contact contact = membership.contact({place.x - c.place.x, place.y - c.place.y});
    if (contact != Contact::empty) result.push_back({k, contact});
  }
  return result;
}

/// Whether copies that touch stop a robot without area that may touch them.
bool SceneQuestions::seam_stops(const std::vector<Point>& path) const {
  const ExactBox box = box_of(path);
  std::vector<PolygonSet> near;
  for (std::uint32_t k = 0; k < scene_.copies.size(); ++k) {
    look_for_interrupt();
    if (!may_meet(k, box)) continue;
    const Copy& c = scene_.copies[k];
    near.push_back(translated(scaled(scene_.shapes[c.shape], c.scale), c.place));
  }
  if (near.size() < 2) return false;
  const PolygonSet obstacles = combined(SetOperation::unite, near).region;
  return valid_scales(scene_.robot, obstacles, path, ContactRule::allowed,
                      {Rational(1), Rational(1)})
      .valid.empty();
}

SceneQuestions::WayAnswer SceneQuestions::way(const std::vector<Point>& path,
                                              ContactRule rule) const {
  const FloatEnvironment standard;
  refuse_empty(path);
  const ExactBox box = box_of(path);
  WayAnswer result;
  for (std::uint32_t k = 0; k < scene_.copies.size(); ++k) {
    look_for_interrupt();
    if (!may_meet(k, box)) continue;
    const Rational& s = scene_.copies[k].scale;
    if (scales(k, path, rule, {s, s}).valid.empty()) result.stopped_by.push_back(k);
  }
  result.free = result.stopped_by.empty();
  if (result.free && !scene_.robot.is_region() && rule == ContactRule::allowed)
    result.free = !seam_stops(path);
  return result;
}

std::optional<Growth> SceneQuestions::growth(const std::vector<Point>& path,
                                             ContactRule rule) const {
  const FloatEnvironment standard;
  if (!way(path, rule).free) return std::nullopt;
  const ExactBox box = box_of(path);
  std::vector<std::pair<Rational, std::uint32_t>> near;
  for (std::uint32_t k = 0; k < scene_.copies.size(); ++k) {
    if (const auto factor = first_factor(k, box)) near.emplace_back(*factor, k);
  }
  std::sort(near.begin(), near.end());
  Growth result;
  for (const auto& [factor, k] : near) {
    look_for_interrupt();
    if (result.factor && factor > *result.factor) break;
    const Rational& s = scene_.copies[k].scale;
    ScaleWindow window{s, std::nullopt};
    if (result.factor) window.to = *result.factor * s;
    const ValidScales found = scales(k, path, rule, window);
    const auto now = std::find_if(found.valid.begin(), found.valid.end(),
                                  [&](const ScaleRange& range) { return range.holds(s); });
    if (now == found.valid.end() || !now->to) continue;
    const auto bound =
        std::find_if(found.bounds.begin(), found.bounds.end(),
                     [&](const PathBound& b) { return b.blocks && b.scale == now->to->scale; });
    if (bound == found.bounds.end()) continue;  // the window's end
    const Rational least = now->to->scale / s;
    if (result.factor && least == *result.factor && result.included <= now->to_in()) continue;
    const Point& y = bound->touching;  // in -R, about the way itself
    result = {least, now->to_in(), k, bound->at, bound->obstacle, bound->part, {}, {}};
    result.at.point = {bound->at.point.x + scene_.copies[k].place.x,
                       bound->at.point.y + scene_.copies[k].place.y};
    result.touching = {result.at.point.x - y.x, result.at.point.y - y.y};
  }
  if (!scene_.robot.is_region() && !scene_.robot.empty() && rule == ContactRule::allowed)
    end_at_seam(path, near, result);
  return result;
}

/// Ends the growth where copies stop the robot together before one of them does alone.
void SceneQuestions::end_at_seam(const std::vector<Point>& path,
                                 const std::vector<std::pair<Rational, std::uint32_t>>& near,
                                 Growth& growth) const {
  std::vector<std::uint32_t> copies;
  for (const auto& [factor, k] : near) {
    if (!growth.factor || factor <= *growth.factor) copies.push_back(k);
  }
  std::sort(copies.begin(), copies.end());
  const auto seam = first_seam(scene_, copies, path, growth.factor);
  if (!seam || (growth.factor && *growth.factor == seam->factor && !seam->at)) return;
  growth = {seam->factor, !seam->at, 0, seam->place, {}, {}, seam->touching, seam->copies};
}

}  // namespace minkref::inline scene
