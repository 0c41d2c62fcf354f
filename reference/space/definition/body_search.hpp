// Convex bodies, and a search for nearby bodies.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// A box around corners, as enclosing doubles.
struct CornerBox {
  Box flat;
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  explicit CornerBox(const CornerRing& corners) {
    for (const auto& [rounded, exact] : corners) {
      const auto& [x, y, z] = rounded;
      flat.add({below(x), below(y), above(x), above(y)});
      bottom = std::min(bottom, below(z));
      top = std::max(top, above(z));
    }
  }
  bool overlaps(const SumBody& body) const {
    return flat.overlaps(body.flat_box) && bottom <= body.top && body.bottom <= top;
  }
};

/// `bodies` must outlive it.
class BodySearch {
 public:
  explicit BodySearch(const std::vector<SumBody>& bodies) : bodies_(bodies) {
    std::vector<Box> boxes;
    boxes.reserve(bodies.size());
    for (const SumBody& body : bodies) boxes.push_back(body.flat_box);
    tree_ = BoxTree(std::move(boxes));
  }

  /// Calls look(b) for each body whose box meets the box.
  template <class Look>
  void near(const CornerBox& box, Look&& look) const {
    tree_.query(box.flat, [&](std::uint32_t b) {
      if (box.overlaps(bodies_[b])) look(b);
      return false;
    });
  }

 private:
  const std::vector<SumBody>& bodies_;
  BoxTree tree_;
};

}  // namespace minkref::inline space
