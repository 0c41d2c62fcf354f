// All triples of a piece of the part, a piece of the obstacles and a segment of the path, and the
// scales at which each of them collides; doubles leave out those that cannot matter.
#pragma once

#include <array>
#include <functional>

#include "reference/number/interval.hpp"
#include "reference/paths/open_pieces.hpp"
#include "reference/paths/strip_polygon.hpp"

namespace minkref::inline paths {

/// A convex piece with the directions across its sides, to the outside; of a segment both.
struct SidedPiece {
  ConvexCorners corners;
  std::vector<Point> across;  ///< exact
  std::vector<std::array<Interval, 2>> near_corners, near_across;

  explicit SidedPiece(ConvexCorners corners);
  /// The greatest product of a corner with a direction.
  Rational reach(const Point& direction) const;
  Interval reach(const std::array<Interval, 2>& direction) const;
};

/// Collisions are strict (interiors meet) or not (points in common).
class MovingPieces {
 public:
  /// Pieces of -R, which slide over the obstacles, and of these. O((a + k) b) in doubles for a, b
  /// sides of pieces and k segments.
  MovingPieces(const PolygonSet& robot, const PolygonSet& obstacles, const std::vector<Point>& path,
               bool strict);

  struct Triple {
    std::uint32_t segment = 0, robot = 0, obstacle = 0;
  };
  /// Scales from and to, the latter infinity where there is none.
  using Gap = std::array<double, 2>;

  /// Calls `take` with each triple that may collide at some scale of one of the gaps, the likely
  /// ones first. `gaps` is read anew each time and may change; `touching`: also with those that may
  /// only touch there.
  void each(const std::vector<Gap>& gaps, bool touching,
            const std::function<void(const Triple&)>& take);

  /// The scales at which a triple collides. Exact.
  std::optional<StripScales> scales(const Triple& triple) const;

  /// The places and scales at which it does, between two scales, of which one is below the other.
  /// Exact.
  std::optional<StripPolygon> polygon(const Triple& triple, const Rational& from,
                                      const Rational& to) const;

  const std::vector<SidedPiece>& robot() const { return robot_; }
  const std::vector<SidedPiece>& obstacles() const { return obstacles_; }
  std::uint64_t triples() const;
  std::uint64_t segments() const { return path_.size() > 1 ? path_.size() - 1 : 1; }
  PathPlace place(std::uint32_t segment, const Rational& t) const;

 private:
  /// Across which direction two pieces and a segment are looked at, in doubles.
  struct Side {
    std::array<Interval, 2> direction;
    std::vector<Interval> path;       ///< products with the vertices of the path
    std::vector<Interval> robot;      ///< reaches of the pieces of -R (of one, for its own sides)
    std::vector<Interval> obstacles;  ///< and of the obstacles
    Interval all_of_robot;
  };
  Side side(const std::array<Interval, 2>& direction, bool robots, bool all_obstacles) const;
  bool apart(const Side& side, std::uint32_t segment, const Interval& robot,
             const Interval& obstacle, const Gap& gap, bool touching) const;
  bool apart_from_all(std::uint32_t segment, std::uint32_t obstacle, const Gap& gap,
                      bool touching) const;
  bool apart(const Triple& triple, const Gap& gap, bool touching) const;
  void put_in_order();
  std::vector<StripCondition> conditions(const Triple& triple) const;
  bool is_point(std::uint32_t segment) const;

  std::vector<SidedPiece> robot_, obstacles_;
  std::vector<Point> path_;
  bool strict_;
  std::vector<std::vector<Side>> of_robot_, of_obstacles_, of_path_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order_;  ///< segment, obstacle
};

}  // namespace minkref::inline paths
