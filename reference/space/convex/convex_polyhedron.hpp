// A strictly convex polyhedron over integers, with its half-edges: the operand of Sec. 6.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

using DoubleVector = std::array<double, 3>;

/// Coplanar faces form one facet, and no vertex lies inside a facet or an edge. The half-edges that
/// leave a vertex have consecutive numbers, counter-clockwise around the vertex seen from outside;
/// a half-edge's facet lies on the left.
class ConvexPolyhedron {
 public:
  /// Validates, merges coplanar faces, drops flat vertices and certifies convexity. Throws BadInput
  /// as `validate` does, and "not-convex" (names a face and a vertex above its plane, as given),
  /// "not-solid" (the empty set, a point, a segment). Exact. O(n log n).
  explicit ConvexPolyhedron(const Polyhedron& surface);

  std::uint32_t vertices() const { return static_cast<std::uint32_t>(points_.size()); }
  std::uint32_t facets() const { return static_cast<std::uint32_t>(normals_.size()); }
  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(target_.size()); }

  /// A vertex is `point(v)` over `denominator()`.
  const Integer& denominator() const { return denominator_; }
  const IntegerVector& point(std::uint32_t vertex) const { return points_[vertex]; }
  /// All point coordinates lie below 2^point_bits() in magnitude.
  long point_bits() const { return point_bits_; }
  /// The points as words, if point_bits() is less than 64; else empty.
  const std::vector<std::array<std::int64_t, 3>>& words() const { return words_; }
  /// Outward, primitive.
  const IntegerVector& normal(std::uint32_t facet) const { return normals_[facet]; }
  /// From origin to target, times `denominator()`.
  IntegerVector vector(std::uint32_t half_edge) const;

  /// The half-edges first(v) .. first(v + 1) - 1 leave v.
  std::uint32_t first(std::uint32_t vertex) const { return first_[vertex]; }
  std::uint32_t origin(std::uint32_t half_edge) const { return target_[twin_[half_edge]]; }
  std::uint32_t target(std::uint32_t half_edge) const { return target_[half_edge]; }
  std::uint32_t twin(std::uint32_t half_edge) const { return twin_[half_edge]; }
  std::uint32_t left(std::uint32_t half_edge) const { return facet_[half_edge]; }
  std::uint32_t right(std::uint32_t half_edge) const { return facet_[twin_[half_edge]]; }
  /// The next half-edge around the facet on its left.
  std::uint32_t next(std::uint32_t half_edge) const { return next_[half_edge]; }
  /// The facet's half-edge that leaves the facet's least vertex.
  std::uint32_t start(std::uint32_t facet) const { return start_[facet]; }
  /// The largest corner count among the facets.
  std::size_t most_corners() const { return most_corners_; }
  /// Edge numbers follow the order of the half-edges that leave the lesser vertex.
  std::uint32_t edges() const { return static_cast<std::uint32_t>(edge_half_.size()); }
  std::uint32_t edge(std::uint32_t half_edge) const { return edge_[half_edge]; }
  /// From the lesser vertex to the greater.
  std::uint32_t half_edge(std::uint32_t edge) const { return edge_half_[edge]; }

  /// The next half-edge around its origin: counter-clockwise, clockwise.
  std::uint32_t onward(std::uint32_t half_edge) const {
    const std::uint32_t v = origin(half_edge);
    return half_edge + 1 == first_[v + 1] ? first_[v] : half_edge + 1;
  }
  std::uint32_t backward(std::uint32_t half_edge) const {
    const std::uint32_t v = origin(half_edge);
    return half_edge == first_[v] ? first_[v + 1] - 1 : half_edge - 1;
  }

  /// Nearest doubles of `vector` and `normal`, each kind scaled by one common power of two that
  /// puts the largest coordinate into [1/2, 1).
  const DoubleVector& rounded_vector(std::uint32_t half_edge) const { return vectors_[half_edge]; }
  const DoubleVector& rounded_normal(std::uint32_t facet) const { return rounded_normals_[facet]; }
  /// Whether every nonzero coordinate gives a double of at least 2^-201 in magnitude above.
  bool moderate() const { return moderate_; }

  /// Nearest doubles of the points over the same power of two as the vectors; for estimates.
  const DoubleVector& rounded_point(std::uint32_t vertex) const { return rounded_points_[vertex]; }

  /// All facets, each but the first with a neighbour that comes before it.
  struct Visit {
    std::uint32_t facet, before;
  };
  const std::vector<Visit>& traversal() const { return traversal_; }

  /// The surface in canonical form (canonical_polyhedron.hpp).
  Polyhedron surface() const;

 private:
  void link(const std::vector<Face>& rings);
  void traverse();

  Integer denominator_ = 1;
  std::vector<IntegerVector> points_, normals_;
  std::vector<std::uint32_t> first_, target_, twin_, facet_, next_, start_, edge_, edge_half_;
  std::vector<DoubleVector> vectors_, rounded_normals_, rounded_points_;
  std::vector<Visit> traversal_;
  bool moderate_ = true;
  long point_bits_ = 0;
  std::size_t most_corners_ = 0;
  std::vector<std::array<std::int64_t, 3>> words_;
};

}  // namespace minkref::inline space
