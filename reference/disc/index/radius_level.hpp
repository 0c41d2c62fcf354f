// How parts of the complement farther away meet at one radius, and fall apart there.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/disc/region/disjoint_sets.hpp"

namespace minkref::inline disc {

/// The diagram's nodes at one radius, by number, and the parts of the complement above to which the
/// nodes lead. Nodes on one flat ridge form one *door*. Exact: the caller decides equality.
class RadiusLevel {
 public:
  /// A level with so many nodes.
  explicit RadiusLevel(std::size_t nodes) : doors_(nodes) {}

  /// Joins two nodes on one flat ridge.
  void join(std::uint32_t a, std::uint32_t b) { doors_.join(a, b); }
  /// A part of the diagram leads from a node into a part of the complement.
  void lead(std::uint32_t node, std::uint32_t part) { ways_.emplace_back(node, part); }

  /// Connected doors and parts. A group without parts is a greatest value of the distance.
  struct Group {
    std::vector<std::uint32_t> nodes;  ///< ascending
    std::vector<std::uint32_t> parts;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways;  ///< from nodes into parts
  };
  /// O(n log n) for n nodes and ways.
  std::vector<Group> groups() const;

  /// For each part of a group except `from`: the node that cuts the part off from `from`. The
  /// part's door lies on a shortest way from `from`, door by door; the node is the first that leads
  /// from such a door into the part. O(n log n).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> cut_off(const Group& group,
                                                               std::uint32_t from) const;

 private:
  DisjointSets doors_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ways_;
};

}  // namespace minkref::inline disc
