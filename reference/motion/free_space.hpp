// The places that a part may take at one scale, and how they hang together.
#pragma once

#include <optional>
#include <vector>

#include "reference/motion/valid_scales.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline motion {

/// A sum's complement as parts: with contact forbidden, the connected components of the closed
/// sum's complement; with contact allowed, the components of the closed complement of the
/// interiors' sum, that is, of the tight passages and the closures of the former components.
class FreeSpace {
 public:
  /// `sum`: canonical, and with tight passages if contact is allowed. `about`: points for later
  /// questions. Exact. O(b log b + k) for b boundary vertices, k times within an edge's box.
  FreeSpace(const Sum& sum, ContactRule rule, const std::vector<Point>& about);

  /// The index of the part that holds a point; none if the point is not free. Part 0 has no bound.
  std::optional<std::size_t> part_of(const Point& x) const;
  std::size_t parts() const { return parts_; }  ///< the unbounded one included

 private:
  void join_touching();
  std::size_t root(std::size_t k) const;
  static bool on_passage(const TightPassage& passage, const Point& x);

  ContactRule rule_;
  std::vector<PolygonSet> cells_;  ///< the unbounded one first, cut off by a box
  std::vector<TightPassage> passages_;
  std::vector<std::size_t> joined_;  ///< cells, then passages
  std::vector<std::size_t> number_;  ///< of each root
  std::size_t parts_ = 0;
};

}  // namespace minkref::inline motion
