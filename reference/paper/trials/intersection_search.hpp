// All intersections of the edges of the reduced convolution at one scale, found afresh: the dynamic
// update's rival on the clock. No sum rests on this.
#pragma once

#include <memory>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The yardstick of Behar & Lien 2012, Table 1: tests every pair of edges with plain doubles, boxes
/// first. *Not exact*: cases that doubles cannot tell count as they happen to round.
class PairwiseSearch {
 public:
  /// Operands must have passed `validate`.
  PairwiseSearch(const PolygonSet& P, const PolygonSet& Q);
  ~PairwiseSearch();

  /// Places the edges at the scale, finds a point of each pair that meets, common ends included,
  /// and returns the count. Treats parallel edges as if they never met. O(N^2) for N edges.
  std::size_t run(const Rational& scale);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The static sum's own search: the contacts of the arrangement, by a tree of boxes, exact.
class ContactSearch {
 public:
  /// Operands must have passed `validate`.
  ContactSearch(const PolygonSet& P, const PolygonSet& Q);
  ~ContactSearch();

  /// Scales P, places the edges, finds for each pair the crossing and the ends of either edge
  /// inside the other, and returns the count. Common ends do not count. Exact. O((N + k) log N) on
  /// usual input.
  std::size_t run(const Rational& scale) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace minkref::inline plane
