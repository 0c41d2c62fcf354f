// Rings over machine words, and the proof for a convex body.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// Rings as point numbers, end to end.
struct Rings {
  std::vector<std::uint32_t> first{0}, corners;

  std::uint32_t size() const { return static_cast<std::uint32_t>(first.size() - 1); }
  std::span<const std::uint32_t> operator[](std::uint32_t ring) const {
    return {corners.data() + first[ring], first[ring + 1] - first[ring]};
  }
  void clear() {
    first.assign(1, 0);
    corners.clear();
  }
  /// Ends the ring whose corners were added last.
  void close() { first.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// The proof of convexity.hpp for points within the limits of words (word_vectors.hpp). A facet
/// lies strictly below a neighbour's plane if the corner after the common edge does: one scalar
/// product for each edge, which doubles settle where they can. Keeps memory between proofs.
class RingCertificate {
 public:
  /// Two rings with a common edge. On a level the second goes on in the plane of the first, or the
  /// first has no area.
  struct Doubt {
    std::uint32_t first, second;
    bool is_level;
  };
  /// The pairs of rings that doubles do not prove to be strictly convex at their common edge: at
  /// least all coplanar ones, and those with a ring without area. Rings are convex polygons whose
  /// first three corners make a triangle, or have no area. Throws std::logic_error unless the rings
  /// close, with two at each edge. Linear but for vertices of many edges.
  const std::vector<Doubt>& doubtful(const std::vector<WordVector>& points, const Rings& rings);

  /// Proves that these rings bound a convex body, each as one facet, without flat corners; throws
  /// std::logic_error otherwise. Exact. Leaves out what the last call of `doubtful` has proven if
  /// the call had these rings, and found none.
  void require(const std::vector<WordVector>& points, const Rings& rings);

 private:
  /// A ring's normal in doubles. With a = |first side|, b = |diagonal|, as sums of magnitudes, each
  /// coordinate is off by less than 5 * 2^-53 a b, and `size` is a b.
  struct Normal {
    double x, y, z, size;
  };
  struct End {
    std::uint64_t key;  ///< twice the edge's greater point, and 1 on the way down
    std::uint32_t ring, corner;
  };

  WideVector exact_normal(std::uint32_t ring) const;
  bool is_below(std::uint32_t ring, const WordVector& along) const;
  int side(std::uint32_t ring, const WordVector& along) const;
  WordVector across(const End& a, const End& b) const;
  void look_at(const std::vector<WordVector>& points, const Rings& rings);
  template <class Visit>
  void for_each_edge(Visit visit);
  void check_ring(std::uint32_t ring) const;
  void check_winding();
  bool is_met(std::uint32_t ring, const WordVector& from, const WordVector& ray) const;

  const std::vector<WordVector>* points_ = nullptr;
  const Rings* rings_ = nullptr;
  std::vector<Normal> normals_;
  std::vector<std::uint32_t> first_end_;
  std::vector<Doubt> doubtful_;
  std::vector<End> ends_;
  std::vector<std::uint8_t> flags_;
  bool proven_ = false;
};

}  // namespace minkref::inline space
