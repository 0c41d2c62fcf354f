// Spans that move along a common line: finds spans that may hold a place at a scale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {

/// A tree over both ends, as doubles next to the exact numbers: an omitted span certainly does not
/// hold the place.
class SpansOnLine {
 public:
  /// From start_p s + start_q to end_p s + end_q, in either order.
  struct Span {
    double start_p, start_q, end_p, end_q;
  };

  /// O(n log n).
  explicit SpansOnLine(const std::vector<Span>& spans);

  /// Calls report(k) for each span that may hold a place, to a double, at a scale > 0. O(log n) for
  /// each if few spans overlap.
  template <class Report>
  void holding(double place, double scale, Report&& report) const {
    if (nodes_.empty()) return;
    const double room = doubt(place, scale);
    const auto look_at = [&](const auto& self, std::size_t at) -> void {
      look_for_interrupt();
      const Node& node = nodes_[at];
      if (node.low_p * scale + node.low_q - place > room) return;
      if (place - node.high_p * scale - node.high_q > room) return;
      if (node.right != 0) {
        self(self, at + 1);
        self(self, node.right);
        return;
      }
      for (std::size_t k = node.begin; k < node.end; ++k) report(order_[k]);
    };
    look_at(look_at, 0);
  }

 private:
  static constexpr std::size_t leaf_size = 4;
  /// Bounds for all ends: low_p s + low_q lies below, high_p s + high_q above.
  struct Node {
    double low_p, low_q, high_p, high_q;
    std::size_t begin, end;  ///< in `order_`
    std::size_t right;       ///< 0 in a leaf; the left child is the next node
  };
  void build(const std::vector<Span>& spans, std::size_t begin, std::size_t end);
  double doubt(double place, double scale) const;

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  double size_ = 0;
};

}  // namespace minkref::inline plane
