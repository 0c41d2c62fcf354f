// The edges of P that may be nearer to an offset curve than the radius, and the curves inside.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/blocked_part.hpp"
#include "reference/near/edge_tree.hpp"

namespace minkref::inline disc {

/// A tree with turned boxes about the edges, in doubles.
class NearEdges {
 public:
  /// `at` must outlive it.
  explicit NearEdges(const PatchesAt& at);

  /// Finds the edges that may come within the radius from a patch: every edge that blocks the
  /// patch, and perhaps more.
  void find(std::uint32_t patch, std::vector<std::uint32_t>& found) const;

  /// Whether a patch, both ends included, is certainly nearer to P than the radius. The patch is
  /// taken apart, and each part must lie within the convex neighbourhood of a single edge: the
  /// neighbourhood contains the corners of a polygon around the part, by more than doubles can err.
  bool is_inside(std::uint32_t patch) const;

 private:
  struct Spot {
    double x, y;
  };
  /// A part of a patch: for an edge from one point to another; for an arc between two unit vectors.
  struct Part {
    Spot first, last;
  };
  bool is_inside(std::uint32_t patch, const Part& part, int depth) const;
  double squared_distance(std::uint32_t edge, const Spot& x) const;

  const PatchesAt& at_;
  struct Edge {
    Spot start, along;
    double inverse_square;
  };
  std::vector<Edge> edges_;
  EdgeTree tree_;
  double radius_, squared_limit_;
};

}  // namespace minkref::inline disc
