// Finds the wall nearest to an apex within a cone.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/decomposition/resolving_cone.hpp"

namespace minkref::inline plane {

/// Segments, numbered from 0 on. Boxes with doubles find candidates; exact numbers decide.
class WallSearch {
 public:
  void add(FilteredPoint from, FilteredPoint to);

  struct Hit {
    Point at;
    Rational squared_length;
    std::uint32_t wall = 0;
  };
  /// The point nearest to the apex on walls in the cone; among equally near points the
  /// lexicographically least, and its wall with the least number. Skips walls that end at the apex.
  /// Throws std::logic_error if no wall meets the cone. Exact. O(log n + k) for k walls about as
  /// near.
  Hit nearest(const ResolvingCone& cone) const;

 private:
  struct Wall {
    FilteredPoint from, to;
    Box box;
  };
  struct Candidate {
    double squared_bound;  ///< no point of the wall in the cone is nearer
    std::uint32_t wall;
  };
  void collect(const Box& about, const ResolvingCone& cone, std::vector<Candidate>& found) const;
  void improve(const ResolvingCone& cone, std::uint32_t wall, Hit& best) const;

  std::vector<Wall> walls_;
  Box all_;
  BoxTree tree_;  ///< over the first walls; few remain
};

}  // namespace minkref::inline plane
