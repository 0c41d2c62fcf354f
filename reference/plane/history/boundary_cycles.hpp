// Closed walks along a set's boundary, from its edges' directions alone.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/critical/moments.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

inline constexpr std::uint32_t no_sub_edge = 0xffffffffU;

/// A boundary edge between two points, along a convolution edge, the set on its left.
struct BoundaryLink {
  std::uint32_t from = 0, to = 0;
  std::uint32_t edge = 0;
  std::uint32_t before = 0, after = 0;  ///< the link's owners elsewhere; ignored here
};

/// The links as closed walks, paired at each point across a wedge of the set's interior or
/// exterior.
struct BoundaryCycles {
  struct Cycle {
    std::uint32_t first = 0;  ///< a link
    bool left = false;        ///< turns to the left in all: by 360 degrees, not by -360
  };
  std::vector<std::uint32_t> next;   ///< of each link
  std::vector<std::uint32_t> cycle;  ///< of each link
  std::vector<Cycle> cycles;
};

class CycleFinder {
 public:
  explicit CycleFinder(const std::vector<RationalEdge>& edges);

  /// Removes all but one of the links between the same points along parallel edges. Returns each
  /// original link's index after the removal. Exact. O(n).
  std::vector<std::uint32_t> remove_duplicates(std::vector<BoundaryLink>& links);

  /// Throws std::logic_error where the links do not close. Exact. O(n) for n links.
  BoundaryCycles find(const std::vector<BoundaryLink>& links, bool interior);

  /// Points where several links start, for the links last given to `find`.
  const std::vector<std::uint32_t>& pinches() const { return pinches_; }

  /// The sign of d_a x d_b.
  int turn(std::uint32_t a, std::uint32_t b) const;
  /// How often the direction passes the horizontal where a walk goes from edge a to edge b: 1 or 0
  /// times to the left, or once to the right (-1). Throws std::logic_error if it turns back.
  int half_turns(std::uint32_t a, std::uint32_t b) const;
  /// Whether two edges are parallel and point the same way.
  bool same_direction(std::uint32_t a, std::uint32_t b) const;

 private:
  bool upper(std::uint32_t edge) const { return upper_[edge]; }
  void prepare(std::size_t points);

  const std::vector<RationalEdge>& edges_;
  std::vector<double> x_, y_;
  std::vector<char> upper_;  ///< the direction's angle is in [0, 180)
  std::vector<std::uint32_t> first_, follow_, touched_, pinches_;
};

}  // namespace minkref::inline plane
