// All triples of a piece of the part, a piece of the obstacles and a segment of the path, and each
// triple's colliding scales; doubles leave out triples without influence. For plane and space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/motion/strip_polygon.hpp"
#include "reference/number/interval.hpp"

namespace minkref::inline motion {

/// Enclosures of a vector.
template <std::size_t Dimension>
using NearVector = std::array<Interval, Dimension>;

template <std::size_t Dimension>
Interval product(const NearVector<Dimension>& a, const NearVector<Dimension>& b) {
  Interval sum = a[0] * b[0];
  for (std::size_t k = 1; k < Dimension; ++k) sum = sum + a[k] * b[k];
  return sum;
}

inline Interval greater(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}

/// The greatest product of a corner with a direction.
template <std::size_t Dimension>
Interval reach_of(const std::vector<NearVector<Dimension>>& corners,
                  const NearVector<Dimension>& direction) {
  Interval most = product(direction, corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    most = greater(most, product(direction, corners[i]));
  }
  return most;
}

/// The scales from and to; a gap without an upper end goes to infinity.
using ScaleGap = std::array<double, 2>;

/// Indices: a segment, a part's piece and an obstacles' piece.
struct PieceTriple {
  std::uint32_t segment = 0, part = 0, obstacle = 0;
};

/// The room that a direction leaves, over the gap, between an obstacle piece that reaches
/// `obstacle` and a piece of -R that reaches `part`; `least`: the segment's least product. Never
/// more than the true room; negative if there may be no room.
inline double room_across(double least, const Interval& part, const Interval& obstacle,
                          const ScaleGap& gap) {
  const double none = -1, reach = part.upper();
  if (std::isinf(gap[1]) && reach > 0) return none;
  const Interval at(reach > 0 ? gap[1] : gap[0]);
  if (std::isinf(reach) || std::isinf(obstacle.upper()) || std::isinf(least)) return none;
  return (Interval(least) - Interval(obstacle.upper()) - at * Interval(reach)).lower();
}

/// Collisions are strict (interiors meet) or not (common points). `Geometry` has the types Point
/// and Piece (a convex piece: its `near_corners`, and `near_across`, directions across its sides to
/// the outside), the number of `dimensions`, and
/// - near(point), point_at(from, to, t);
/// - across(from, to): directions at right angles to a segment;
/// - conditions(part, obstacle, from, to): the colliding places of a segment and scales; exact;
/// - apart(part, obstacle, from, to, gap, strict): whether doubles prove by other means that the
///   two never collide, or (unless `strict`) touch, at scales of the gap.
template <class Geometry>
class MovingPiecesOf {
 public:
  using Point = typename Geometry::Point;
  using Piece = typename Geometry::Piece;
  using Near = NearVector<Geometry::dimensions>;
  using Triple = PieceTriple;
  using Gap = ScaleGap;

  /// Takes the pieces of -R, sliding over the obstacles, and the obstacles' pieces. O((a + k) b)
  /// doubles for a, b sides of pieces and k segments.
  MovingPiecesOf(std::vector<Piece> part, std::vector<Piece> obstacles, std::vector<Point> path,
                 bool strict);

  /// Calls `take` with each triple that may collide at some scale of any gap, likely triples first.
  /// `gaps` is read anew each time and may change; `touching`: includes triples possibly only
  /// touching there.
  void each(const std::vector<Gap>& gaps, bool touching,
            const std::function<void(const Triple&)>& take) const;

  /// The scales at which a triple collides. Exact.
  std::optional<StripScales> scales(const Triple& triple) const {
    const auto polygon = polygon_of(triple, conditions(triple));
    if (!polygon) return std::nullopt;
    return scales_of(*polygon);
  }

  /// The triple's colliding places and scales between two different scales, the lower scale first.
  /// Exact.
  std::optional<StripPolygon> polygon(const Triple& triple, const Rational& from,
                                      const Rational& to) const {
    std::vector<StripCondition> all = conditions(triple);
    all.push_back({0, -1, from});
    all.push_back({0, 1, -to});
    return polygon_of(triple, all);
  }

  /// The segment's least place where a triple collides at a scale, or the limit of such places.
  /// Exact.
  std::optional<Rational> first_place(const Triple& triple, const Rational& scale) const {
    return least_place(conditions(triple), scale, strict_,
                       path_[triple.segment] == end_of(triple.segment));
  }

  const std::vector<Piece>& part() const { return part_; }
  const std::vector<Piece>& obstacles() const { return obstacles_; }
  bool is_strict() const { return strict_; }
  std::uint64_t triples() const { return segments() * part_.size() * obstacles_.size(); }
  std::uint64_t segments() const { return path_.size() > 1 ? path_.size() - 1 : 1; }
  PathPlaceOf<Point> place(std::uint32_t segment, const Rational& t) const {
    return {segment, t, Geometry::point_at(path_[segment], end_of(segment), t)};
  }

 private:
  /// A direction across which two pieces and a segment are compared, with doubles.
  struct Side {
    Near direction;
    std::vector<Interval> path;       ///< products with the vertices of the path
    std::vector<Interval> part;       ///< reaches of the pieces of -R (of one, for its own sides)
    std::vector<Interval> obstacles;  ///< and of the obstacles
    Interval all_of_part;
  };
  std::size_t next(std::uint32_t segment) const {
    return std::min<std::size_t>(segment + 1, path_.size() - 1);
  }
  const Point& end_of(std::uint32_t segment) const { return path_[next(segment)]; }
  std::vector<StripCondition> conditions(const Triple& triple) const {
    return Geometry::conditions(part_[triple.part], obstacles_[triple.obstacle],
                                path_[triple.segment], end_of(triple.segment));
  }
  std::optional<StripPolygon> polygon_of(const Triple& triple,
                                         const std::vector<StripCondition>& all) const {
    return strip_polygon(all, strict_, path_[triple.segment] == end_of(triple.segment));
  }
  Side side(const Near& direction, bool parts, bool all_obstacles) const;
  bool apart(const Side& side, std::uint32_t segment, const Interval& part,
             const Interval& obstacle, const Gap& gap, bool touching) const;
  bool apart_from_all(std::uint32_t segment, std::uint32_t obstacle, const Gap& gap,
                      bool touching) const;
  bool apart(const Triple& triple, const Gap& gap, bool touching) const;
  void put_in_order();

  std::vector<Piece> part_, obstacles_;
  std::vector<Point> path_;
  std::vector<Near> near_path_;
  bool strict_;
  std::vector<std::vector<Side>> of_robot_, of_obstacles_, of_path_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order_;  ///< segment, obstacle
};

template <class Geometry>
MovingPiecesOf<Geometry>::MovingPiecesOf(std::vector<Piece> part, std::vector<Piece> obstacles,
                                         std::vector<Point> path, bool strict)
    : part_(std::move(part)),
      obstacles_(std::move(obstacles)),
      path_(std::move(path)),
      strict_(strict) {
  for (const Point& p : path_) near_path_.push_back(Geometry::near(p));
  if (part_.empty() || obstacles_.empty()) return;
  for (const Piece& piece : part_) {
    look_for_interrupt();
    auto& sides = of_robot_.emplace_back();
    for (const auto& direction : piece.near_across) sides.push_back(side(direction, false, true));
    for (Side& s : sides) s.part = {reach_of(piece.near_corners, s.direction)};
  }
  for (const Piece& piece : obstacles_) {
    look_for_interrupt();
    auto& sides = of_obstacles_.emplace_back();
    for (const auto& direction : piece.near_across) sides.push_back(side(direction, true, false));
    for (Side& s : sides) s.obstacles = {reach_of(piece.near_corners, s.direction)};
  }
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    look_for_interrupt();
    auto& sides = of_path_.emplace_back();
    if (path_[i] == path_[i + 1]) continue;  // no direction across it
    for (const Near& direction : Geometry::across(path_[i], path_[i + 1])) {
      sides.push_back(side(direction, true, true));
    }
  }
  if (of_path_.empty()) of_path_.emplace_back();
  put_in_order();
}

template <class Geometry>
auto MovingPiecesOf<Geometry>::side(const Near& direction, bool parts, bool all_obstacles) const
    -> Side {
  Side result;
  result.direction = direction;
  for (const Near& p : near_path_) result.path.push_back(product(direction, p));
  for (std::size_t k = 0; parts && k < part_.size(); ++k) {
    result.part.push_back(reach_of(part_[k].near_corners, direction));
    result.all_of_part = k == 0 ? result.part[0] : greater(result.all_of_part, result.part.back());
  }
  for (std::size_t k = 0; all_obstacles && k < obstacles_.size(); ++k) {
    result.obstacles.push_back(reach_of(obstacles_[k].near_corners, direction));
  }
  return result;
}

/// Sorts segments and obstacle pieces, near pairs first: a guess from doubles.
template <class Geometry>
void MovingPiecesOf<Geometry>::put_in_order() {
  using Rounded = std::array<double, Geometry::dimensions>;
  std::vector<std::pair<double, std::pair<std::uint32_t, std::uint32_t>>> near_first;
  const auto minus = [](const Near& a, const Rounded& b) {
    Rounded difference;
    for (std::size_t k = 0; k < b.size(); ++k) difference[k] = approximate(a[k]) - b[k];
    return difference;
  };
  const auto times = [](const Rounded& a, const Rounded& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
  };
  for (std::uint32_t i = 0; i < segments(); ++i) {
    const Rounded from = minus(near_path_[i], Rounded{});
    const Rounded along = minus(near_path_[next(i)], from);
    const double length = times(along, along);
    for (std::uint32_t k = 0; k < obstacles_.size(); ++k) {
      double least = std::numeric_limits<double>::infinity();
      for (const Near& corner : obstacles_[k].near_corners) {
        Rounded way = minus(corner, from);
        const double t = length > 0 ? std::clamp(times(way, along) / length, 0.0, 1.0) : 0.0;
        for (std::size_t axis = 0; axis < way.size(); ++axis) way[axis] -= t * along[axis];
        least = std::min(least, std::sqrt(times(way, way)));
      }
      near_first.push_back({std::isnan(least) ? 0 : least, {i, k}});
    }
  }
  std::sort(near_first.begin(), near_first.end());
  for (const auto& [distance, pair] : near_first) order_.push_back(pair);
}

template <class Geometry>
bool MovingPiecesOf<Geometry>::apart(const Side& side, std::uint32_t segment, const Interval& part,
                                     const Interval& obstacle, const Gap& gap,
                                     bool touching) const {
  const double least = std::min(side.path[segment].lower(), side.path[next(segment)].lower());
  const double free = room_across(least, part, obstacle, gap);
  return strict_ && !touching ? free >= 0 : free > 0;
}

template <class Geometry>
bool MovingPiecesOf<Geometry>::apart_from_all(std::uint32_t segment, std::uint32_t obstacle,
                                              const Gap& gap, bool touching) const {
  for (const Side& s : of_obstacles_[obstacle]) {
    if (apart(s, segment, s.all_of_part, s.obstacles[0], gap, touching)) return true;
  }
  for (const Side& s : of_path_[segment]) {
    if (apart(s, segment, s.all_of_part, s.obstacles[obstacle], gap, touching)) return true;
  }
  return false;
}

template <class Geometry>
bool MovingPiecesOf<Geometry>::apart(const Triple& triple, const Gap& gap, bool touching) const {
  const auto [segment, part, obstacle] = triple;
  for (const Side& s : of_obstacles_[obstacle]) {
    if (apart(s, segment, s.part[part], s.obstacles[0], gap, touching)) return true;
  }
  for (const Side& s : of_robot_[part]) {
    if (apart(s, segment, s.part[0], s.obstacles[obstacle], gap, touching)) return true;
  }
  for (const Side& s : of_path_[segment]) {
    if (apart(s, segment, s.part[part], s.obstacles[obstacle], gap, touching)) return true;
  }
  return Geometry::apart(part_[part], obstacles_[obstacle], near_path_[segment],
                         near_path_[next(segment)], gap, strict_ && !touching);
}

template <class Geometry>
void MovingPiecesOf<Geometry>::each(const std::vector<Gap>& gaps, bool touching,
                                    const std::function<void(const Triple&)>& take) const {
  const auto near_some_gap = [&](const auto& apart_at) {
    return std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) { return !apart_at(gap); });
  };
  for (const auto& pair : order_) {
    look_for_interrupt();
    if (!near_some_gap([&](const Gap& gap) {
          return apart_from_all(pair.first, pair.second, gap, touching);
        })) {
      continue;
    }
    for (std::uint32_t part = 0; part < part_.size(); ++part) {
      const Triple triple{pair.first, part, pair.second};
      if (near_some_gap([&](const Gap& gap) { return apart(triple, gap, touching); })) {
        take(triple);
      }
    }
  }
}

}  // namespace minkref::inline motion
