#include "reference/plane/dynamic/sub_edge_status.hpp"

#include <cmath>

#include "reference/plane/dynamic/passing_edges.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/moving/double_range.hpp"
#include "reference/plane/moving/right_of_edge.hpp"

namespace minkref::inline plane {

SubEdgeStatus::SubEdgeStatus(const PolygonSet& P, const PolygonSet& Q,
                             const ArrangementEvents& events, const SweptEdge& swept)
    : events_(events),
      swept_(swept),
      interior_(P, Q),
      regions_(has_area(P) && has_area(Q)),
      may_hide_passages_(may_hide_passages(P, Q)),
      always_on_one_line_(events.edges().size(), [&](auto&& add) {
        for (const MeetingPair& pair : events.pairs().meeting) {
          if (pair.kind != MeetingPair::Kind::one_line_always) continue;
          add(pair.a, pair.b);
          add(pair.b, pair.a);
        }
      }) {
  for (const RationalEdge& e : events.moving()) {
    doubles_.push_back({filter_double(e.p.x()), filter_double(e.p.y()), filter_double(e.q.x()),
                        filter_double(e.q.y()), filter_double(e.d.x()), filter_double(e.d.y())});
  }
}

SubEdgeStatus::Place SubEdgeStatus::place(double along, double along_terms, double s) const {
  const DoubleEdge& e = doubles_[swept_.edge()];
  const double terms =
      std::max(std::abs(e.px) * s + std::abs(e.qx), std::abs(e.py) * s + std::abs(e.qy)) +
      std::max(std::abs(e.dx), std::abs(e.dy)) * along_terms;
  return {e.px * s + e.qx + e.dx * along, e.py * s + e.qy + e.dy * along, terms * 0x1p-46 + 1e-300};
}

/// Whether the sub-edge just after (or before) a node runs left of the edge that crosses there,
/// where everything lies inside the sum. False if doubles cannot tell.
bool SubEdgeStatus::certainly_left(std::uint32_t local, bool after, double s) const {
  // A point or a segment need not widen an edge where another ring touches it.
  if (!regions_ || !in_filter_range(s)) return false;
  if (local >= swept_.count() || swept_.node(local).kind != EdgeNode::Kind::crossing) return false;
  const std::uint32_t other = swept_.node(local).other;
  const DoubleEdge &e = doubles_[swept_.edge()], &f = doubles_[other];
  const double left = f.dx * e.dy, right = f.dy * e.dx;
  const double bound = (std::abs(left) + std::abs(right)) * 0x1p-48 + 1e-300;
  if (after ? !(left - right > bound) : !(left - right < -bound)) return false;
  // Excludes the ends of the other edge, beyond which it has no left side.
  const Place x = place(swept_.near(local, s), swept_.terms(local, s), s);
  const double length = events_.moving()[other].is_s() ? s : 1.0;
  const double ax = f.px * s + f.qx, ay = f.py * s + f.qy;
  const double bx = ax + f.dx * length, by = ay + f.dy * length;
  const double error =
      x.error + (std::abs(f.px) * s + std::abs(f.qx) + std::abs(f.py) * s + std::abs(f.qy) +
                 std::abs(f.dx) * length + std::abs(f.dy) * length) *
                    0x1p-46;
  const auto apart = [&](double ux, double uy) {
    return std::abs(x.x - ux) > error || std::abs(x.y - uy) > error;
  };
  return apart(ax, ay) && apart(bx, by);
}

/// Whether an opposite edge on the same line runs along a point of this edge.
bool SubEdgeStatus::covered_against(const Point& x, const Rational& scale,
                                    std::uint32_t other) const {
  const RationalEdge& f = events_.moving()[other];
  return minkref::sign(PlainKernel<Rational>::dot(swept_.moving().d, f.d)) < 0 &&
         runs_along(swept_.moving(), f, x, scale);
}

Status SubEdgeStatus::at(std::uint32_t x, std::uint32_t y, const SampleScale& sample,
                         const std::vector<std::uint32_t>& overlaps) {
  const double s = sample.approximate;
  const Place near = place((swept_.near(x, s) + swept_.near(y, s)) / 2,
                           swept_.terms(x, s) + swept_.terms(y, s), s);
  if (interior_.certainly_inside(near.x, near.y, near.error, s)) {
    ++decided_by_doubles;
    return Status::interior;
  }
  ++decided_exactly;
  const Point point = swept_.middle(x, y, sample.scale);
  if (interior_.inside(point, sample.scale)) return Status::interior;
  const auto against = [&](std::uint32_t other) {
    return covered_against(point, sample.scale, other);
  };
  const std::span<const std::uint32_t> one_line = always_on_one_line_.of(swept_.edge());
  // Possibly no edge bounds one side of a passage through a point of touching rings.
  const bool tight =
      std::any_of(one_line.begin(), one_line.end(), against) ||
      std::any_of(overlaps.begin(), overlaps.end(), against) ||
      (may_hide_passages_ && sum_on_the_right(swept_.moving(), point, sample.scale, interior_));
  return tight ? Status::tight : Status::boundary;
}

Status SubEdgeStatus::between(std::uint32_t x, std::uint32_t y, std::uint32_t low,
                              std::uint32_t high) {
  const SampleScale sample = scale_between(events_, low, high);
  if (certainly_left(x, true, sample.approximate) || certainly_left(y, false, sample.approximate)) {
    return Status::interior;
  }
  return at(x, y, sample);
}

}  // namespace minkref::inline plane
