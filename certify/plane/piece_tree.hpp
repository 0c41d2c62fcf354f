// An operand as a tiling by convex pieces, and a tree that groups the pieces.
#pragma once

#include <array>
#include <unordered_map>

#include "certify/plane/linear.hpp"
#include "reference/plane/kernel/box.hpp"

namespace minkref::certify {

/// Vertex numbers follow the order of rings. Node n is a piece, or group n - pieces; the last node,
/// if any, holds all pieces.
class PieceTree {
 public:
  struct Node {
    std::vector<std::uint32_t> hull;  ///< vertices, counter-clockwise
    std::array<std::uint32_t, 2> children{};
    bool is_piece = true;
    Box box;
    double extent = 0;  ///< the longer side of the box
  };

  /// Triangles, merged while they stay convex; groups by median splits. The set has passed
  /// `validate`. O(n^2), for the triangulation.
  PieceTree(const PolygonSet& set, NormalTable& normals);

  const std::vector<Place>& vertices() const { return vertices_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  std::size_t pieces() const { return pieces_; }
  std::uint32_t root() const { return static_cast<std::uint32_t>(nodes_.size() - 1); }

  /// The largest value of a normal on the hull of a node.
  const Value& most(std::uint32_t node, std::uint32_t normal) const;
  /// Outward normals of a hull's edges; both normals for a segment.
  const std::vector<std::uint32_t>& outward(std::uint32_t node) const { return outward_[node]; }

 private:
  void add_pieces(const PolygonSet& set);
  std::uint32_t group(std::vector<std::uint32_t> items);
  void add_node(Node node);

  NormalTable& normals_;
  std::vector<Place> vertices_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::uint32_t>> outward_;
  std::size_t pieces_ = 0;
  mutable std::unordered_map<std::uint64_t, Value> most_;
};

}  // namespace minkref::certify
