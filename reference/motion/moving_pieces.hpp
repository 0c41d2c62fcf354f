// Convex pieces that move along a path of the plane.
#pragma once

#include "reference/motion/moving_pieces_of.hpp"
#include "reference/motion/open_pieces.hpp"

namespace minkref::inline motion {

/// A convex piece with the directions across its sides, to the outside; of a segment both.
struct SidedPiece {
  ConvexCorners corners;
  std::vector<Point> across;  ///< exact
  std::vector<NearVector<2>> near_corners, near_across;

  explicit SidedPiece(ConvexCorners corners);
  /// The greatest product of a corner with a direction. Exact.
  Rational reach(const Point& direction) const;
};

/// The plane's Geometry for MovingPiecesOf.
struct PathsInThePlane {
  using Point = plane::Point;
  using Piece = SidedPiece;
  static constexpr std::size_t dimensions = 2;
  static NearVector<2> near(const Point& p) { return {Interval(p.x), Interval(p.y)}; }
  static Point point_at(const Point& from, const Point& to, const Rational& t);
  static std::vector<NearVector<2>> across(const Point& from, const Point& to);
  static std::vector<StripCondition> conditions(const SidedPiece& part, const SidedPiece& obstacle,
                                                const Point& from, const Point& to);
  /// Returns false: the sides alone tell everything.
  static bool apart(const SidedPiece&, const SidedPiece&, const NearVector<2>&,
                    const NearVector<2>&, const ScaleGap&, bool) {
    return false;
  }
};
extern template class MovingPiecesOf<PathsInThePlane>;

class MovingPieces : public MovingPiecesOf<PathsInThePlane> {
 public:
  /// Takes the pieces of -R, which slide over the obstacles, and of the obstacles.
  MovingPieces(const PolygonSet& part, const PolygonSet& obstacles, const std::vector<Point>& path,
               bool strict);
};

}  // namespace minkref::inline motion
