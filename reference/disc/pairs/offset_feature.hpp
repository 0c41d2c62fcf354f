// The features of the Appendix (Behar & Lien 2012): offset edges, and the whole arc about a vertex.
#pragma once

#include <array>
#include <vector>

#include "reference/disc/curves/patch_numbers.hpp"

namespace minkref::inline disc {

/// At the radius ρ an edge of P, moved outwards, or an arc about a convex vertex. The ends are the
/// points `at[k]` + ρ `way[k]` / |`way[k]`|, ordered with P on the left.
struct OffsetFeature {
  bool is_arc = false;
  std::array<Point, 2> at;                  ///< the ends of the edge; of an arc its centre, twice
  std::array<Direction, 2> way;             ///< outwards at both ends; of an edge as long as it is
  VertexId id{};                            ///< of an edge: where it starts
  std::uint32_t curve = OffsetPatch::none;  ///< its number among the curves' features

  /// From p to q, with P on the left. Throws BadInput ("bad-feature") if p equals q.
  static OffsetFeature edge(const Point& p, const Point& q);
  /// About a vertex at which P turns left, or back, between edges along `in` and `out`. Throws
  /// BadInput ("bad-feature") if it does not.
  static OffsetFeature arc(const Point& centre, const Direction& in, const Direction& out);
};

/// Edges in the curves' order, then arcs: one about each vertex, however many parts it was cut
/// into. A circle about a point is left out: it has no ends, and nothing to meet. O(n log n).
std::vector<OffsetFeature> offset_features(const OffsetCurves& curves);

/// A feature as intervals or as roots.
template <class N>
struct FeatureNumbers {
  bool is_arc = false;
  std::array<Vector<N>, 2> at, way;
  std::array<N, 2> squared_way;
  Vector<N> along;  ///< of an edge

  FeatureNumbers() = default;
  explicit FeatureNumbers(const OffsetFeature& feature)
      : is_arc(feature.is_arc), along(numbers<N>(from_to(feature.at[0], feature.at[1]))) {
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] = numbers<N>(feature.at[k]);
      way[k] = numbers<N>(feature.way[k]);
      squared_way[k] = N(Rational(dot(feature.way[k], feature.way[k])));
    }
  }
};

}  // namespace minkref::inline disc
