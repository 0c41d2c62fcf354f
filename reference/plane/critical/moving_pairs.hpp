// Pairs of convolution edges that may meet at some scale of a window: by a tree of moving boxes,
// then by the float filter.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/moving_box.hpp"
#include "reference/plane/critical/pair_filter.hpp"

namespace minkref::inline plane {

/// An edge as doubles: from s p + q, along s d for an S-edge, along d for a T-edge.
struct RoundedEdge {
  double px = 0, py = 0, qx = 0, qy = 0, dx = 0, dy = 0;
  bool is_s = false;
};

/// Two edges as moving half-lines: the place of b's line along a is (a_slope s + a_value) / c, for
/// an S-edge of s c; `low` to `high` are the scales at which they may meet, within a window.
struct PairRange {
  double c, a_slope, a_value, b_slope, b_value, low, high;
  bool is_parallel;  ///< c is too small to be told from 0; the rest is not set

  bool is_empty() const { return !is_parallel && low > high; }
};

/// An empty range is certain: each condition slope s + value >= 0 is tested with both coefficients
/// shifted by the error.
PairRange pair_range(const RoundedEdge& a, const RoundedEdge& b, double from, double to,
                     double error);

/// Finds the pairs that may meet at some scale within a closed window; an omitted pair certainly
/// does not. Divided by 1 + s, each vertex moves from q to p along a line, so the window may have
/// no bounds. Edges near each other share a block, an upright box, and a box along most edges: the
/// float filter looks at whole blocks.
class MovingPairs {
 public:
  struct Box {
    static constexpr std::size_t dimensions = 2;
    std::array<double, 2> low, high;
    Box();
    void add(const Box& other);
    void add(double x, double y, double error);
    bool is_within(double most) const;
    double centre(std::size_t axis) const { return low[axis] / 2 + high[axis] / 2; }
  };
  using MovingBox = BasicMovingBox<Box>;
  using Spot = std::array<double, 2>;  ///< divided by 1 + s
  /// An edge's two ends at both ends of the window, and how far each coordinate may err.
  struct Way {
    std::array<Spot, 2> at_first, at_last;
    double error_at_first, error_at_last;
    MovingBox box() const { return box_along({1, 0}); }
    /// In coordinates along a unit vector, and across.
    MovingBox box_along(const Spot& along) const;
  };
  static Way way_of(const RoundedEdge& edge, double from, double to);

  /// `to` may be infinite. `wanted` asks for the pairs of some edges only; empty: of all. O(n log
  /// n) for n edges, not counting unwanted edges far from all wanted ones.
  MovingPairs(const std::vector<RoundedEdge>& edges, double from, double to,
              const std::vector<char>& wanted = {});

  double error() const { return filter_.error(); }
  /// The number of blocks with wanted edges.
  std::size_t blocks() const { return wanted_.size(); }

  /// Calls report(a, b), a < b, for the pairs of a block's edges with each other, with edges of
  /// later blocks and with unwanted edges: over all blocks, once for each pair with a wanted edge.
  /// `room` is kept for the next call.
  template <class Report>
  void of_block(std::uint32_t place, std::vector<std::uint32_t>& room, Report&& report) const {
    room.resize(block_size + 1);
    const std::uint32_t number = wanted_[place];
    const Block& own = blocks_[number];
    for (std::uint32_t a = own.first; a < own.last; ++a) look(own, a, own, a + 1, room, report);
    tree_.query(own.box, [&](std::uint32_t other) {
      const Block& later = blocks_[other];
      if (other == number || (later.is_wanted && other < number)) return false;
      if (are_apart(own, later)) return false;
      // The filter looks from S-edges at T-edges.
      const bool from_own = own.is_s || !later.is_s;
      look(from_own ? own : later, from_own ? later : own, room, report);
      return false;
    });
  }

 private:
  static constexpr std::uint32_t block_size = 32;
  /// Edges that share a kind, numbered as in the filter; S-edges have the first blocks.
  struct Block {
    bool is_s, is_wanted;
    std::uint32_t first, last;
    MovingBox box;
    Spot along;  ///< the direction of most edges
    MovingBox turned;
  };
  static Spot direction_of(const std::vector<Way>& ways, const std::uint32_t* begin,
                           const std::uint32_t* end);
  /// Sorts so that each block_size in a row lie beside each other.
  static void cluster(const std::vector<Way>& ways, std::uint32_t* begin, std::uint32_t* end);
  static bool are_apart(const Block& a, const Block& b);

  template <class Report>
  void look(const Block& own, const Block& other, std::vector<std::uint32_t>& room,
            Report& report) const {
    for (std::uint32_t a = own.first; a < own.last; ++a) {
      if (ways_[own.is_s][a].box().overlaps(other.box) &&
          ways_[own.is_s][a].box_along(other.along).overlaps(other.turned)) {
        look(own, a, other, other.first, room, report);
      }
    }
  }

  template <class Report>
  void look(const Block& own, std::uint32_t a, const Block& other, std::uint32_t first,
            std::vector<std::uint32_t>& room, Report& report) const {
    look_for_interrupt();
    const std::size_t count =
        filter_.candidates(own.is_s, a, other.is_s, first, other.last, room.data());
    const std::uint32_t edge = edges_[own.is_s][a];
    for (std::size_t k = 0; k < count; ++k) {
      look_for_interrupt();
      const std::uint32_t with = edges_[other.is_s][room[k]];
      report(std::min(edge, with), std::max(edge, with));
    }
  }

  std::array<std::vector<std::uint32_t>, 2> edges_;  ///< T-edges, S-edges, in the filter's order
  std::array<std::vector<Way>, 2> ways_;             ///< in this order
  void add_blocks(bool is_s, bool is_wanted, const std::vector<RoundedEdge>& edges,
                  const std::vector<std::uint32_t>& which, double from, double to);

  std::vector<Block> blocks_;
  std::vector<std::uint32_t> wanted_;  ///< blocks
  BasicBoxTree<MovingBox> tree_;       ///< of blocks
  PairFilter filter_;
};

}  // namespace minkref::inline plane
