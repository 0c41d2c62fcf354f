// All intersections of the edges of the reduced convolution at one scale, found afresh: what the
// dynamic update is timed against. No sum rests on this.
#pragma once

#include <memory>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The yardstick of Behar & Lien 2012, Table 1: every pair of edges is looked at, in plain doubles,
/// boxes first. *Not exact*: what doubles cannot tell is counted as they happen to round.
class PairwiseSearch {
 public:
  /// Operands must have passed `validate`.
  PairwiseSearch(const PolygonSet& P, const PolygonSet& Q);
  ~PairwiseSearch();

  /// Places the edges at the scale and finds a point of each pair that meets, common ends included;
  /// how many there are. Parallel edges are taken not to meet. O(N^2) for N edges.
  std::size_t run(const Rational& scale);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The search that the static sum makes: the contacts of the arrangement, by a tree of boxes,
/// exact.
class ContactSearch {
 public:
  /// Operands must have passed `validate`.
  ContactSearch(const PolygonSet& P, const PolygonSet& Q);
  ~ContactSearch();

  /// Scales P, places the edges and finds, for each pair of them, where they cross and which ends
  /// of one lie inside of the other; how many there are. Common ends are not counted. Exact.
  /// O((N + k) log N) on usual input.
  std::size_t run(const Rational& scale) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace minkref::inline plane
