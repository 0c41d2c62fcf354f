// The best way between two nodes of a graph of heights: at its lowest node it is as high as can be.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace minkref::inline disc {

/// Best ways by levels, which are whole numbers: nodes that are joined at one level are one *door*.
class LevelWays {
 public:
  using Numbers = std::vector<std::uint32_t>;

  /// `joined`: the nodes next to each node, both ways; it must outlive this. `level`: of a node.
  LevelWays(const std::vector<Numbers>& joined,
            const std::function<std::uint32_t(std::uint32_t)>& level);

  struct Found {
    bool is_connected = false;
    std::uint32_t level = 0;  ///< the least on the way
    /// On a way with the fewest doors, for each door of that level in order a node at which the way
    /// enters it; none if an end is a node of the level.
    Numbers doors;
  };
  /// Finds a best way. O(n log n) for n nodes and links.
  Found find(std::uint32_t start, std::uint32_t end) const;

 private:
  Numbers doors_between(const Numbers& nodes, const std::vector<Numbers>& parts, std::uint32_t from,
                        std::uint32_t to) const;

  const std::vector<Numbers>& joined_;
  Numbers levels_;
};

}  // namespace minkref::inline disc
