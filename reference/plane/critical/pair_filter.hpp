// The float filter over pairs of convolution edges: which pairs certainly never meet.
#pragma once

#include <cstdint>
#include <vector>

namespace minkref::inline plane {

/// Coordinates of moving edges of one kind as doubles, column by column.
struct EdgeColumns {
  std::vector<double> px, py, qx, qy, dx, dy;
  std::size_t size = 0;
  void add(double px_, double py_, double qx_, double qy_, double dx_, double dy_);
  /// Fills up the last block; no more edges may be added.
  void close();
};

/// Finds the pairs that may meet at some s > 0. A pair that it leaves out certainly does not meet:
/// each condition slope s + value >= 0 is taken with both coefficients off by `error`, which bounds
/// the rounding of all that leads to them.
class PairFilter {
 public:
  /// Each double given is the nearest one to the exact coordinate.
  PairFilter(EdgeColumns s_edges, EdgeColumns t_edges);

  /// The edges with index from `first` on, of one kind, that edge `a` may meet; indices within the
  /// kind. `out` has room for all.
  std::size_t candidates(bool a_is_s, std::uint32_t a, bool b_is_s, std::uint32_t first,
                         std::uint32_t* out) const;

  /// Bounds by how much the doubles of c, A and B (docs/definitions.md) are off.
  double error() const { return error_; }

 private:
  EdgeColumns s_, t_;
  double error_ = 0;
};

}  // namespace minkref::inline plane
