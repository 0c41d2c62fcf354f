// Whether a sub-edge of the arrangement lies on the boundary of the sum.
#pragma once

#include "reference/plane/dynamic/edge_happenings.hpp"
#include "reference/plane/dynamic/gap_status.hpp"
#include "reference/plane/dynamic/scale_between.hpp"
#include "reference/plane/dynamic/swept_edge.hpp"
#include "reference/plane/moving/interior_test.hpp"

namespace minkref::inline plane {

/// Collision detection (Behar & Lien 2012, Sec. 3) for the middle of a sub-edge of the swept edge.
/// Exact: doubles decide only what they can prove.
class SubEdgeStatus {
 public:
  /// `swept` must outlive it.
  SubEdgeStatus(const PolygonSet& P, const PolygonSet& Q, const ArrangementEvents& events,
                const SweptEdge& swept);

  /// Between two neighbours at a scale; `overlaps`: edges that share this line at this scale only.
  Status at(std::uint32_t x, std::uint32_t y, const SampleScale& sample,
            const std::vector<std::uint32_t>& overlaps = {});
  /// Between two neighbours at all scales between two groups that follow each other on this edge
  /// (`always`: the end of the window).
  Status between(std::uint32_t x, std::uint32_t y, std::uint32_t low, std::uint32_t high);

  /// How often collision detection was asked and answered by doubles, and by exact numbers.
  std::uint64_t decided_by_doubles = 0, decided_exactly = 0;

 private:
  struct DoubleEdge {
    double px, py, qx, qy, dx, dy;
  };
  struct Place {
    double x, y, error;
  };
  Place place(double along, double along_terms, double s) const;
  bool certainly_left(std::uint32_t local, bool after, double s) const;
  bool covered_against(const Point& x, const Rational& scale, std::uint32_t other) const;

  const ArrangementEvents& events_;
  const SweptEdge& swept_;
  InteriorTest interior_;
  bool regions_, may_hide_passages_;
  std::vector<DoubleEdge> doubles_;
  ByEdge<std::uint32_t> always_on_one_line_;  ///< edges on the line of an edge at every scale
};

}  // namespace minkref::inline plane
