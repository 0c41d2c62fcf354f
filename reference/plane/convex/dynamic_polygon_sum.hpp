// The sum of convex polygons kept up to date under non-uniform scaling: where to start.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "reference/plane/convex/convex_ring.hpp"
#include "reference/plane/scaling.hpp"

namespace minkref::inline plane {

/// Counts one update's errors and steps (Behar & Lien 2012, Sec. 6, in the plane).
struct PolygonUpdateCounts {
  std::uint64_t ev_errors = 0;      ///< edges of P whose vertex of Q changed
  std::uint64_t ve_errors = 0;      ///< edges of Q whose vertex of P changed
  std::uint64_t descent_steps = 0;  ///< edges walked from the old vertices to the new ones
};

/// A place on the axis of the ratios s_y / s_x: a ratio, or just below or above one.
struct RatioPlace {
  Rational ratio;
  int side = 0;
  friend bool operator<(const RatioPlace& a, const RatioPlace& b) {
    return a.ratio < b.ratio || (a.ratio == b.ratio && a.side < b.side);
  }
};

/// An interval of ratios; an absent end means unbounded.
struct RatioInterval {
  std::optional<RatioPlace> begin, end;

  /// Keeps the ratios r with `u - r w > 0`, or else those with `u - r w <= 0`.
  void keep(const Rational& u, const Rational& w, bool positive);
};

/// Pairs sorted by an end of their compatible ratios, so an update finds the errors without looking
/// at the other pairs.
using PairsByEnd = std::set<std::pair<RatioPlace, std::uint32_t>>;

/// `S P + Q` for changing S and convex polygons, as pairs of an edge and the compatible vertex of
/// the other operand (docs/definitions.md, "Compatibility", with its half-open turns). P and Q are
/// copied.
///
/// Whether an edge a of P, scaled, turns left to an edge b of Q is the sign of `u - r w`, with
/// u = a.x b.y, w = a.y b.x and r = s_y / s_x: a pair stays compatible for an interval of ratios.
/// An update to another ratio finds the pairs whose interval is left, and repairs each by descent:
/// along the boundary of the other operand, each step to a vertex that lies farther along the
/// edge's normal. Exact. An update takes O((k + d) log(m + n)) for k errors and d steps.
class DynamicPolygonSum {
 public:
  /// Builds from scratch, merging the edges by angle: O((m + n) log(m + n)). Throws BadInput
  /// ("not-convex", "bad-scale").
  DynamicPolygonSum(const PolygonSet& P, const PolygonSet& Q, const PlaneScaling& at);

  /// Mends the pairs that the new scaling makes wrong. Throws BadInput ("bad-scale") and keeps the
  /// state.
  PolygonUpdateCounts update(const PlaneScaling& to);

  /// The sum in canonical form. O(m + n).
  PolygonSet region() const;

  const PlaneScaling& scaling() const { return scaling_; }
  /// For each edge of P its vertex from Q; for each edge of Q its vertex from P.
  const std::vector<std::uint32_t>& vertex_of_Q() const { return of_P_.vertex; }
  const std::vector<std::uint32_t>& vertex_of_P() const { return of_Q_.vertex; }

 private:
  /// Pairs one operand's edges with the second operand's vertices.
  struct Pairs {
    std::vector<std::uint32_t> vertex;
    std::vector<RatioInterval> compatible;
    PairsByEnd by_begin, by_end;
  };

  int turn(std::size_t edge_of_P, std::size_t edge_of_Q) const;
  bool goes_before(std::size_t edge_of_Q, std::size_t edge_of_P) const;
  bool rises_backward(bool is_P, std::size_t edge, std::size_t vertex) const;
  bool rises_forward(bool is_P, std::size_t edge, std::size_t vertex) const;
  void merge();
  void mend(bool is_P, std::uint64_t& errors, std::uint64_t& steps);
  void insert(bool is_P, std::uint32_t edge);
  std::size_t edges_of_Q_before(std::size_t edge_of_P) const;
  bool have_one_direction(std::size_t edge_of_P, std::size_t edge_of_Q) const;

  ConvexRing P_, Q_;
  PlaneScaling scaling_;
  Rational ratio_;
  Pairs of_P_, of_Q_;
};

}  // namespace minkref::inline plane
