// Whether P meets x - Q, for a point x in general position: the sum contains x iff both meet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/edges/flat_pieces.hpp"
#include "reference/space/edges/interior_cells.hpp"
#include "reference/space/edges/nudged_point.hpp"

namespace minkref::inline space {

/// An operand's surface: triangles, flat faces' pieces, and bare edges. If an edge pierces the
/// other operand's face, the boxes of an element with this edge and an element with this part of
/// the face overlap.
class CollisionElements {
 public:
  CollisionElements(const SpaceOperand& body, FlatPieces pieces);
  CollisionElements(const CollisionElements&) = delete;  // items point to pieces

  struct Item {
    const FlatPiece* piece;  ///< null for a triangle or an edge
    std::uint32_t number;    ///< of a triangle, else of an edge
    bool is_edge;
  };
  const SpaceOperand& body;
  FlatPieces pieces;
  std::vector<Item> items;
  SpaceBoxTree tree;
};

/// Data that all tests for a sum share.
class CollisionTrees {
 public:
  /// Pieces may be left out: triangles stand for all faces then.
  CollisionTrees(const SpaceOperand& P, const SpaceOperand& Q, InteriorCells cells,
                 FlatPieces pieces_of_P = {}, FlatPieces pieces_of_Q = {});
  const SpaceOperand &P, &Q;
  CollisionElements of_P, of_Q;
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
  bool vertex_inside(const NudgedPoint& x, const CollisionElements& body, const SpaceBox& box,
                     const SpaceOperand& other);
  bool inside(const NudgedPoint& x, const CollisionElements& body, const FilteredVector& vertex);

  const CollisionTrees& trees_;
  const SpaceOperand &P_, &Q_;
  std::array<Pair, 12> recent_{};
  std::size_t known_ = 0, next_ = 0;
};

}  // namespace minkref::inline space
