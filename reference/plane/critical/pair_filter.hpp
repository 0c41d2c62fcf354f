// The float filter over pairs of convolution edges: finds pairs that certainly never meet.
#pragma once

#include <cstdint>
#include <vector>

namespace minkref::inline plane {

/// Moving edges that share a kind: coordinates as columns of doubles.
struct EdgeColumns {
  std::vector<double> px, py, qx, qy, dx, dy;
  std::size_t size = 0;
  void add(double px_, double py_, double qx_, double qy_, double dx_, double dy_);
  /// Fills up the last block; no more edges may be added.
  void close();
};

/// Finds the pairs that may meet at some s > 0. Omitted pairs certainly do not meet: each condition
/// slope s + value >= 0 is tested with both coefficients shifted by `error`, a bound on all
/// rounding before.
class PairFilter {
 public:
  PairFilter() = default;
  /// Requires the nearest double for each exact coordinate.
  PairFilter(EdgeColumns s_edges, EdgeColumns t_edges);

  /// The edges from `first` up to `last`, excluded, of one kind, that edge `a` may meet, as indices
  /// within the kind; of a T-edge among T-edges only. `out` must have room for all.
  std::size_t candidates(bool a_is_s, std::uint32_t a, bool b_is_s, std::uint32_t first,
                         std::uint32_t last, std::uint32_t* out) const;

  /// Bounds the errors of the doubles c, A and B (docs/definitions.md).
  double error() const { return error_; }

 private:
  EdgeColumns s_, t_;
  double error_ = 0;
};

}  // namespace minkref::inline plane
