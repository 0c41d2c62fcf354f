// All sums sP + Q of a window of scales, built once: any one is then read off.
#pragma once

#include <vector>

#include "reference/scalespace/ring_order.hpp"

namespace minkref {

/// The boundary at a scale in doubles: rings one after the other, in no particular order, outer
/// ones counter-clockwise and holes clockwise, without straight vertices. Each coordinate is off by
/// at most `error`.
struct RoundedRings {
  std::vector<double> x, y;
  std::vector<std::uint32_t> ring_ends;  ///< behind the last vertex of each ring
  double error = 0;
};

class ScaleSpaceIndex {
 public:
  /// Exact. Operands must have passed `validate`. Throws BadInput ("bad-window").
  ScaleSpaceIndex(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                  unsigned threads = 1);

  const ScaleWindow& window() const { return swept_.window; }
  const SweptBoundary& swept() const { return swept_; }
  const MovingBoundary& boundary() const { return boundary_; }
  const std::vector<RingBucket>& buckets() const { return buckets_; }

  /// Where a scale of the window is: the interval that holds it, or the one below the event at
  /// which it is. Throws BadInput ("outside-window"). O(log e) for e events, in doubles as a rule.
  struct Place {
    std::uint32_t interval = 0;
    bool at_event = false;
  };
  Place place(const Rational& scale) const;

  /// The sum in canonical form, without statistics and passages. Exact. O(b log b) for a boundary
  /// of b edges.
  Sum sum(const Rational& scale) const;

  /// The boundary at a scale that is no event's: at one it has edges without length, or touches
  /// itself. Writes into `rings`, whose memory is used again. O(b); some ns a vertex.
  void rings(std::uint32_t interval, double scale, RoundedRings& rings) const;

 private:
  const RingBucket& bucket_of(std::uint32_t interval) const { return buckets_[bucket_[interval]]; }

  struct TrackInDoubles {
    double x0, y0, x1, y1;
  };
  /// An entry of a bucket with all that a query in doubles needs.
  struct RoundedEntry {
    std::uint32_t first, last, track, direction;
  };

  SweptBoundary swept_;
  MovingBoundary boundary_;
  std::vector<RingBucket> buckets_;
  std::vector<std::uint32_t> bucket_;               // of each interval
  std::vector<double> near_events_;                 // of the events
  std::vector<TrackInDoubles> rounded_;             // of the tracks
  std::vector<std::uint32_t> direction_;            // of each edge of the convolution, a number
  std::vector<std::vector<RoundedEntry>> entries_;  // of each bucket
  double largest_ = 0;                              // of the tracks' coefficients
};

}  // namespace minkref
