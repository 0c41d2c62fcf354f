// Whether P meets x - Q, for a point x in general position: the sum contains x iff both meet.
#pragma once

#include <array>
#include <cstdint>

#include "reference/space/edges/interior_cells.hpp"
#include "reference/space/edges/nudged_point.hpp"

namespace minkref::inline space {

/// Data that all tests for a sum share.
class CollisionTrees {
 public:
  CollisionTrees(const SpaceOperand& P, const SpaceOperand& Q, InteriorCells cells);
  const SpaceOperand &P, &Q;
  SpaceBoxTree tree_P, tree_Q;  ///< of triangles, or of the segment
  SpaceBox box_P, box_Q;
  InteriorCells cells;
};

/// One thread's tests, which first try the pairs last found to meet.
class Collision {
 public:
  explicit Collision(const CollisionTrees& trees) : trees_(trees), P_(trees.P), Q_(trees.Q) {}

  /// Whether P ⊕ Q contains x. Exact. O(n) at worst; the trees leave few pairs of triangles.
  bool contains(const NudgedPoint& x);

  SignCounts signs;
  std::uint64_t tests = 0, covered = 0;  ///< of these, answered by cells

 private:
  struct Pair {
    std::uint32_t of_P, of_Q;
  };

  bool surfaces_cross(const NudgedPoint& x);
  bool meet(const NudgedPoint& x, std::uint32_t of_P, std::uint32_t of_Q);
  bool vertex_inside(const NudgedPoint& x, const SpaceOperand& body, const SpaceBoxTree& triangles,
                     const SpaceBox& box, const SpaceOperand& other);
  bool inside(const NudgedPoint& x, const SpaceOperand& body, const SpaceBoxTree& triangles,
              const FilteredVector& vertex);

  const CollisionTrees& trees_;
  const SpaceOperand &P_, &Q_;
  std::array<Pair, 12> recent_{};
  std::size_t known_ = 0, next_ = 0;
};

}  // namespace minkref::inline space
