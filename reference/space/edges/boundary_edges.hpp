// A sum's boundary edges: pieces of carriers beside an outside sector.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/edges/carrier.hpp"
#include "reference/space/edges/collision.hpp"

namespace minkref::inline space {

/// An edge between two faces of the boundary, with the outside between them. Seen from outside the
/// first face has the edge from `from` to `to` on its border, counter-clockwise, and the second the
/// edge back.
struct BoundaryEdge {
  SpacePoint from, to;          ///< over the denominator of the operands
  std::uint32_t first, second;  ///< facets in whose planes the faces lie
};

struct EdgeStatistics {
  SignCounts signs;
  std::uint64_t pieces = 0, candidates = 0, tests = 0;
  std::uint64_t covered = 0;  ///< of the tests, answered by cells
  std::uint64_t nanoseconds_of_tests = 0;
};

/// One thread's search.
class BoundaryEdgeSearch {
 public:
  BoundaryEdgeSearch(const Convolution& convolution,
                     const std::vector<std::vector<std::uint32_t>>& near,
                     const CollisionTrees& trees)
      : facets_(convolution.facets), cutting_(convolution, near, trees.cells), collision_(trees) {}

  void look_along_side(std::uint32_t side) { look_along(cutting_.cut_side(side)); }
  void look_along_crossing(std::uint32_t a, std::uint32_t b) {
    look_along(cutting_.cut_crossing(a, b));
  }

  std::vector<BoundaryEdge> edges;
  EdgeStatistics statistics() const;

 private:
  /// A half-plane about the line: on the side of direction x (sign * normal).
  struct Ray {
    std::uint32_t facet;
    int sign;
  };

  void look_along(const std::vector<CarrierPiece>& pieces);
  void sort_rays(const CarrierPiece& piece);
  int turn(const Ray& a, const Ray& b);
  bool is_outside(const CarrierPiece& piece, const Ray& first, const Ray& second, bool narrow);
  SpacePoint point_at(const Cut& cut) const;

  const std::vector<ConvolutionFacet>& facets_;
  CarrierCutting cutting_;
  Collision collision_;
  std::uint64_t nanoseconds_of_tests_ = 0;
  std::vector<Ray> rays_;
  std::vector<std::size_t> bundles_;  ///< where rays of one direction begin, and the end
  std::uint64_t pieces_ = 0, candidates_ = 0;
};

}  // namespace minkref::inline space
