// Walls, and the nearest of them within a cone.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/decomposition/resolving_cone.hpp"

namespace minkref::inline plane {

/// Segments, numbered as they are added. Boxes of doubles find candidates; exact numbers decide.
class WallSearch {
 public:
  void add(FilteredPoint from, FilteredPoint to);

  struct Hit {
    Point at;
    Rational squared_length;
    std::uint32_t wall = 0;
  };
  /// The point of all walls in the cone that is nearest to the apex: as near, the lexicographically
  /// least; on several walls, the wall with the least number. Walls that end at the apex do not
  /// count. Throws std::logic_error if no wall meets the cone. Exact. O(log n + k) for k walls
  /// about as near.
  Hit nearest(const ResolvingCone& cone) const;

 private:
  struct Wall {
    FilteredPoint from, to;
    Box box;
  };
  struct Candidate {
    double squared_bound;  ///< no point of the wall's box is nearer
    std::uint32_t wall;
  };
  void collect(const Box& about, const Box& apex, std::vector<Candidate>& found) const;
  void improve(const ResolvingCone& cone, std::uint32_t wall, Hit& best) const;

  std::vector<Wall> walls_;
  Box all_;
  BoxTree tree_;  ///< over the first walls; the others are few
};

}  // namespace minkref::inline plane
