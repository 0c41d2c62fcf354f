#include "reference/paths/moving_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/interrupt.hpp"
#include "reference/paths/routes.hpp"

namespace minkref::inline paths {
namespace {

std::array<Interval, 2> near(const Point& p) { return {Interval(p.x), Interval(p.y)}; }

Interval product(const std::array<Interval, 2>& a, const std::array<Interval, 2>& b) {
  return a[0] * b[0] + a[1] * b[1];
}

Interval greater(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}

std::vector<SidedPiece> sided(const std::vector<ConvexCorners>& pieces) {
  std::vector<SidedPiece> result;
  for (const ConvexCorners& piece : pieces) result.emplace_back(piece);
  return result;
}

}  // namespace

SidedPiece::SidedPiece(ConvexCorners corners_) : corners(std::move(corners_)) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n > 1 && i < n; ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % n];
    across.push_back({b.y - a.y, a.x - b.x});
  }
  for (const Point& p : corners) near_corners.push_back(near(p));
  for (const Point& p : across) near_across.push_back(near(p));
}

Rational SidedPiece::reach(const Point& direction) const {
  Rational most;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Rational one = direction.x * corners[i].x + direction.y * corners[i].y;
    if (i == 0 || one > most) most = std::move(one);
  }
  return most;
}

Interval SidedPiece::reach(const std::array<Interval, 2>& direction) const {
  Interval most = product(direction, near_corners[0]);
  for (std::size_t i = 1; i < near_corners.size(); ++i) {
    most = greater(most, product(direction, near_corners[i]));
  }
  return most;
}

MovingPieces::MovingPieces(const PolygonSet& robot, const PolygonSet& obstacles,
                           const std::vector<Point>& path, bool strict)
    : robot_(sided(open_pieces(half_turned(robot), strict && !obstacles.is_region()))),
      obstacles_(sided(open_pieces(obstacles, strict && !robot.is_region()))),
      path_(path),
      strict_(strict) {
  if (robot_.empty() || obstacles_.empty()) return;
  for (const SidedPiece& piece : robot_) {
    look_for_interrupt();
    auto& sides = of_robot_.emplace_back();
    for (const auto& direction : piece.near_across) sides.push_back(side(direction, false, true));
    for (Side& s : sides) s.robot = {piece.reach(s.direction)};
  }
  for (const SidedPiece& piece : obstacles_) {
    look_for_interrupt();
    auto& sides = of_obstacles_.emplace_back();
    for (const auto& direction : piece.near_across) sides.push_back(side(direction, true, false));
    for (Side& s : sides) s.obstacles = {piece.reach(s.direction)};
  }
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    look_for_interrupt();
    const Point &a = path_[i], &b = path_[i + 1];
    auto& sides = of_path_.emplace_back();
    if (a == b) continue;  // no direction across it
    sides.push_back(side(near({b.y - a.y, a.x - b.x}), true, true));
    sides.push_back(side(near({a.y - b.y, b.x - a.x}), true, true));
  }
  if (of_path_.empty()) of_path_.emplace_back();
  put_in_order();
}

MovingPieces::Side MovingPieces::side(const std::array<Interval, 2>& direction, bool robots,
                                      bool all_obstacles) const {
  Side result;
  result.direction = direction;
  for (const Point& p : path_) result.path.push_back(product(direction, near(p)));
  for (std::size_t k = 0; robots && k < robot_.size(); ++k) {
    result.robot.push_back(robot_[k].reach(direction));
    result.all_of_robot =
        k == 0 ? result.robot[0] : greater(result.all_of_robot, result.robot.back());
  }
  for (std::size_t k = 0; all_obstacles && k < obstacles_.size(); ++k) {
    result.obstacles.push_back(obstacles_[k].reach(direction));
  }
  return result;
}

/// Segments and pieces of obstacles, those that are near to each other first: a guess, in doubles.
void MovingPieces::put_in_order() {
  std::vector<std::pair<double, std::pair<std::uint32_t, std::uint32_t>>> near_first;
  const auto middle = [](const Interval& x) { return approximate(x); };
  std::vector<std::array<double, 2>> path;
  for (const Point& p : path_) path.push_back({to_double(p.x), to_double(p.y)});
  for (std::uint32_t i = 0; i < segments(); ++i) {
    const auto &a = path[i], &b = path[std::min<std::size_t>(i + 1, path.size() - 1)];
    const double ux = b[0] - a[0], uy = b[1] - a[1], length = ux * ux + uy * uy;
    for (std::uint32_t k = 0; k < obstacles_.size(); ++k) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& corner : obstacles_[k].near_corners) {
        const double vx = middle(corner[0]) - a[0], vy = middle(corner[1]) - a[1];
        const double t = length > 0 ? std::clamp((vx * ux + vy * uy) / length, 0.0, 1.0) : 0.0;
        least = std::min(least, std::hypot(vx - t * ux, vy - t * uy));
      }
      near_first.push_back({std::isnan(least) ? 0 : least, {i, k}});
    }
  }
  std::sort(near_first.begin(), near_first.end());
  for (const auto& [distance, pair] : near_first) order_.push_back(pair);
}

bool MovingPieces::apart(const Side& side, std::uint32_t segment, const Interval& robot,
                         const Interval& obstacle, const Gap& gap, bool touching) const {
  const std::size_t next = std::min<std::size_t>(segment + 1, path_.size() - 1);
  const double least = std::min(side.path[segment].lower(), side.path[next].lower());
  const double reach = robot.upper();
  if (std::isinf(gap[1]) && reach > 0) return false;
  const Interval at(reach > 0 ? gap[1] : gap[0]);
  if (std::isinf(reach) || std::isinf(obstacle.upper()) || std::isinf(least)) return false;
  const double free = (Interval(least) - Interval(obstacle.upper()) - at * Interval(reach)).lower();
  return strict_ && !touching ? free >= 0 : free > 0;
}

bool MovingPieces::apart_from_all(std::uint32_t segment, std::uint32_t obstacle, const Gap& gap,
                                  bool touching) const {
  for (const Side& s : of_obstacles_[obstacle]) {
    if (apart(s, segment, s.all_of_robot, s.obstacles[0], gap, touching)) return true;
  }
  for (const Side& s : of_path_[segment]) {
    if (apart(s, segment, s.all_of_robot, s.obstacles[obstacle], gap, touching)) return true;
  }
  return false;
}

bool MovingPieces::apart(const Triple& triple, const Gap& gap, bool touching) const {
  const auto [segment, robot, obstacle] = triple;
  for (const Side& s : of_obstacles_[obstacle]) {
    if (apart(s, segment, s.robot[robot], s.obstacles[0], gap, touching)) return true;
  }
  for (const Side& s : of_robot_[robot]) {
    if (apart(s, segment, s.robot[0], s.obstacles[obstacle], gap, touching)) return true;
  }
  for (const Side& s : of_path_[segment]) {
    if (apart(s, segment, s.robot[robot], s.obstacles[obstacle], gap, touching)) return true;
  }
  return false;
}

void MovingPieces::each(const std::vector<Gap>& gaps, bool touching,
                        const std::function<void(const Triple&)>& take) {
  const auto near_some_gap = [&](const auto& apart_at) {
    return std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return !apart_at(gap); });
  };
  for (const auto& [segment, obstacle] : order_) {
    look_for_interrupt();
    if (!near_some_gap(
            [&](const Gap& gap) { return apart_from_all(segment, obstacle, gap, touching); })) {
      continue;
    }
    for (std::uint32_t robot = 0; robot < robot_.size(); ++robot) {
      const Triple triple{segment, robot, obstacle};
      if (near_some_gap([&](const Gap& gap) { return apart(triple, gap, touching); })) {
        take(triple);
      }
    }
  }
}

std::vector<StripCondition> MovingPieces::conditions(const Triple& triple) const {
  const Point& a = path_[triple.segment];
  const Point& b = path_[std::min<std::size_t>(triple.segment + 1, path_.size() - 1)];
  const Point along{b.x - a.x, b.y - a.y};
  const SidedPiece &robot = robot_[triple.robot], &obstacle = obstacles_[triple.obstacle];
  std::vector<StripCondition> conditions;
  for (const SidedPiece* piece : {&obstacle, &robot}) {
    for (const Point& n : piece->across) {
      conditions.push_back({n.x * along.x + n.y * along.y, -robot.reach(n),
                            n.x * a.x + n.y * a.y - obstacle.reach(n)});
    }
  }
  return conditions;
}

bool MovingPieces::is_point(std::uint32_t segment) const {
  return path_[segment] == path_[std::min<std::size_t>(segment + 1, path_.size() - 1)];
}

std::optional<StripScales> MovingPieces::scales(const Triple& triple) const {
  const auto polygon = strip_polygon(conditions(triple), strict_, is_point(triple.segment));
  if (!polygon) return std::nullopt;
  return scales_of(*polygon);
}

std::optional<StripPolygon> MovingPieces::polygon(const Triple& triple, const Rational& from,
                                                  const Rational& to) const {
  std::vector<StripCondition> all = conditions(triple);
  all.push_back({0, -1, from});
  all.push_back({0, 1, -to});
  return strip_polygon(all, strict_, is_point(triple.segment));
}

std::uint64_t MovingPieces::triples() const {
  return segments() * robot_.size() * obstacles_.size();
}

PathPlace MovingPieces::place(std::uint32_t segment, const Rational& t) const {
  const Point& a = path_[segment];
  const Point& b = path_[std::min<std::size_t>(segment + 1, path_.size() - 1)];
  return {segment, t, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}};
}

}  // namespace minkref::inline paths
