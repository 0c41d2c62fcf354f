// Whether a part collides on a path at one scale: the sweep of each piece, against obstacles.
#pragma once

#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/valid_scales.hpp"
#include "reference/space/definition/convex_clip.hpp"

namespace minkref::inline space {

/// A convex piece A of the part sweeps the convex set of all x + sA, x on a segment. The sweep
/// meets an obstacle B's interior iff some face of the sweep has a point strictly inside B, or an
/// inner point of B lies strictly inside the sweep.
class SweptPieces {
 public:
  /// Requires that at most one operand is thin.
  SweptPieces(const Polyhedron& part, const Polyhedron& obstacles,
              const std::vector<SpacePoint>& path, ContactRule rule);

  /// Exact. O(a b k) for a and b pieces and k segments.
  bool collide(const Rational& scale);

  std::size_t pieces_of_robot() const { return part_.size(); }
  std::size_t pieces_of_obstacles() const { return obstacles_.size(); }

 private:
  struct Sweep {
    std::uint32_t segment, part;
    SpacePoint from, along;
    std::vector<SpacePoint> normals;  ///< of the sweep, and perhaps more
    bool is_solid;
  };
  /// At one scale.
  struct Placed {
    std::vector<std::vector<SpacePoint>> faces;  ///< hold the whole boundary
    std::vector<HalfSpace> planes;
    SpaceBox box;
  };
  Placed placed(const Sweep& sweep, const Rational& scale) const;
  bool collides(const Sweep& sweep, const Placed& at, std::size_t obstacle) const;

  bool strict_;  ///< interiors meet
  std::vector<SolidPiece> part_, obstacles_;
  std::vector<std::vector<HalfSpace>> planes_;               ///< of obstacles
  std::vector<std::vector<std::vector<SpacePoint>>> faces_;  ///< of obstacles; thin ones whole
  std::vector<Sweep> sweeps_;
  std::vector<std::pair<std::size_t, std::size_t>> likely_;  ///< the last that collided, first
};

}  // namespace minkref::inline space
