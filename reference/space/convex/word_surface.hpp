// The surface of a dynamic convex sum in machine words, made for one scaling after another.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/space/convex/convex_sum.hpp"
#include "reference/space/convex/ring_certificate.hpp"
#include "reference/space/convex/sum_coordinates.hpp"

namespace minkref::inline space {

/// The canonical form of `surface_of`, certified alike, with points over one denominator for each
/// axis. No sorting by planes: most pieces become facets where doubles prove them strictly
/// convex to all neighbours; the rest merges, plane by plane. Keeps all memory.
class WordSurface {
 public:
  /// Takes the sum as it stands now. Returns false, and has no surface, if its numerators have more
  /// bits than words may (word_vectors.hpp). Throws std::logic_error if the proof fails; then, and
  /// after an interrupt, there is no surface until the next call. Exact.
  /// O(k log k) at worst, nearly linear for points in general position.
  bool renew(const DynamicConvexSum& sum);

  const IntegerVector& denominators() const { return coordinates_.denominators; }
  /// In lexicographic order.
  const std::vector<WordVector>& points() const { return points_; }
  const std::vector<SumVertices::Pair>& vertex_parents() const { return parents_; }
  /// Ascending, each from the least vertex on.
  const Rings& facets() const { return facets_; }
  /// How many pieces the last `renew` merged.
  std::uint64_t merged() const { return merged_; }

  /// The sum, as `surface_of` gives it.
  ConvexSum sum() const;

 private:
  void list_pieces(const DynamicConvexSum& sum);
  void number_sides(const DynamicConvexSum& sum);
  void merge(const std::vector<RingCertificate::Doubt>& doubtful);
  void unite_coplanar(const std::vector<RingCertificate::Doubt>& doubtful);
  bool in_one_plane(std::uint32_t piece, std::uint32_t other) const;
  std::uint32_t root(std::uint32_t piece);
  void order_vertices();
  void order_facets();
  FacetParents facet_parents(std::uint32_t facet) const;
  const std::vector<WordVector>& numerators() const;
  /// The facets, their corners as numbers of pairs.
  const Rings& rings() const { return is_united_ ? united_ : pieces_; }

  HomogeneousPoints coordinates_;         // of all pairs
  std::vector<SumVertices::Pair> pairs_;  // p q in the order of coordinates_
  Rings pieces_, united_;
  bool is_united_ = false;
  std::vector<WideVector> normals_;   // of doubtful pieces; zero without area
  std::vector<std::uint32_t> group_;  // of each piece: another of its plane, or of its line
  std::vector<std::array<std::uint32_t, 2>> beside_;  // of pieces without area: one in each plane
  std::vector<std::uint32_t> piece_of_;  // of united_[r]: those from first_piece_[r] on
  std::vector<std::uint32_t> first_piece_;
  std::uint64_t merged_ = 0;
  RingCertificate certificate_;
  // The result.
  std::vector<WordVector> points_;
  std::vector<SumVertices::Pair> parents_;
  Rings facets_;
  std::vector<std::uint32_t> ring_of_;  // of a facet
  // While pieces are listed.
  std::vector<std::uint32_t> number_of_;                // by q, beside one p
  std::vector<std::uint32_t> whole_number_, corner_;    // by q; by half-edge of P
  std::vector<std::uint32_t> first_link_, ends_[2];     // by edge of P; by link
  std::vector<std::uint32_t> first_facet_, facets_at_;  // of Q by vertex of P
  // While the result is ordered.
  std::vector<std::uint8_t> is_used_, is_doubtful_;
  std::vector<std::uint64_t> keys_, spare_keys_;
  std::vector<std::uint32_t> rank_, first_of_, lowest_;
};

}  // namespace minkref::inline space
