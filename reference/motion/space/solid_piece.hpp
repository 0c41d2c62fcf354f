// Convex pieces that move along a path through space.
#pragma once

#include <utility>

#include "reference/motion/moving_pieces_of.hpp"
#include "reference/space/box_tree.hpp"
#include "reference/space/definition/exact_vectors.hpp"

namespace minkref::inline space {

/// Whether the operand has no volume: empty, a point, a segment, a plane polygon.
inline bool is_thin(const Polyhedron& polyhedron) { return polyhedron.faces.size() < 2; }

/// The set -R, its faces turned outwards again.
Polyhedron half_turned(const Polyhedron& part);

/// A convex polyhedron or plane polygon, a segment or a point, with all that its sums with others
/// take their planes from.
struct SolidPiece {
  /// An edge's two corners, and a further corner of each adjacent face.
  struct Edge {
    std::uint32_t from, to;
    std::vector<std::uint32_t> beside;
  };

  std::vector<SpacePoint> corners;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<SpacePoint> across;  ///< normals of the faces; of a plane polygon both
  std::vector<NearVector<3>> near_corners, near_across;
  SpaceBox box;

  explicit SolidPiece(const Polyhedron& convex);
  bool is_solid() const { return faces.size() > 1; }
  /// The greatest product of a corner with a direction. Exact.
  Rational reach(const SpacePoint& direction) const;
  /// Exact.
  bool contains(const SpacePoint& point) const;
  SpacePoint middle() const;
};

/// The space Geometry for MovingPiecesOf.
struct PathsInSpace {
  using Point = SpacePoint;
  using Piece = SolidPiece;
  static constexpr std::size_t dimensions = 3;
  static NearVector<3> near(const SpacePoint& p) {
    return {Interval(p.x), Interval(p.y), Interval(p.z)};
  }
  static SpacePoint point_at(const SpacePoint& from, const SpacePoint& to, const Rational& t) {
    return from + t * (to - from);
  }
  static std::vector<NearVector<3>> across(const SpacePoint& from, const SpacePoint& to);
  /// Each facet of B ⊕ -sA is parallel to a face of A or B, or to an edge from each.
  static std::vector<StripCondition> conditions(const SolidPiece& part, const SolidPiece& obstacle,
                                                const SpacePoint& from, const SpacePoint& to);
  /// Looks for a plane between the obstacle and the part's sweep at all scales of the gap
  /// (Gilbert's descent, with doubles), and proves the plane by intervals.
  static bool apart(const SolidPiece& part, const SolidPiece& obstacle, const NearVector<3>& from,
                    const NearVector<3>& to, const ScaleGap& gap, bool strict);
};

}  // namespace minkref::inline space

namespace minkref::inline motion {
extern template class MovingPiecesOf<PathsInSpace>;
}  // namespace minkref::inline motion

namespace minkref::inline space {
using MovingSolids = MovingPiecesOf<PathsInSpace>;
}  // namespace minkref::inline space
