// Where parts of the complement that are farther away meet at one radius, and fall apart there.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/region/disjoint_sets.hpp"

namespace minkref::inline disc {

/// The nodes of the diagram at one radius, by number, and the parts of the complement above it that
/// they lead to. Nodes on one flat ridge are one *door*. Exact: it is told what is equal.
class RadiusLevel {
 public:
  /// A level with so many nodes.
  explicit RadiusLevel(std::size_t nodes) : doors_(nodes) {}

  /// Two nodes are on one flat ridge.
  void join(std::uint32_t a, std::uint32_t b) { doors_.join(a, b); }
  /// A part of the diagram leads from a node into a part of the complement.
  void lead(std::uint32_t node, std::uint32_t part) { ways_.emplace_back(node, part); }

  /// Doors and parts that hang together. Without parts it is a greatest value of the distance.
  struct Group {
    std::vector<std::uint32_t> nodes;  ///< ascending
    std::vector<std::uint32_t> parts;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways;  ///< from nodes into parts
  };
  /// O(n log n) for n nodes and ways.
  std::vector<Group> groups() const;

  /// By part, all but one of a group: the node at which it is cut off from that one. The door to a
  /// part is one of those on the shortest ways from that one, door by door; the node is the first
  /// of them that leads from such a door into the part. O(n log n).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> cut_off(const Group& group,
                                                               std::uint32_t from) const;

 private:
  DisjointSets doors_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ways_;
};

}  // namespace minkref::inline disc
