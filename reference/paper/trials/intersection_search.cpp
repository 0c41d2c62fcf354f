#include "reference/paper/trials/intersection_search.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "reference/number/float_environment.hpp"
#include "reference/number/rational.hpp"
#include "reference/plane/convolution/convolution_segments.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {
namespace {

/// A segment and its box, with doubles.
struct Placed {
  double x0, y0, x1, y1;
  double left, right, low, high;
};

double side(const Placed& line, double x, double y) {
  return (line.x1 - line.x0) * (y - line.y0) - (line.y1 - line.y0) * (x - line.x0);
}

bool boxes_meet(const Placed& a, const Placed& b) {
  return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
}

/// Appends the point where two segments meet.
void meet(const Placed& a, const Placed& b, std::vector<double>& points) {
  const double b0 = side(a, b.x0, b.y0), b1 = side(a, b.x1, b.y1);
  if ((b0 > 0 && b1 > 0) || (b0 < 0 && b1 < 0) || b0 == b1) return;
  const double a0 = side(b, a.x0, a.y0), a1 = side(b, a.x1, a.y1);
  if ((a0 > 0 && a1 > 0) || (a0 < 0 && a1 < 0) || a0 == a1) return;
  const double t = a0 / (a0 - a1);
  points.push_back(a.x0 + t * (a.x1 - a.x0));
  points.push_back(a.y0 + t * (a.y1 - a.y0));
}

}  // namespace

struct PairwiseSearch::Impl {
  struct Ends {
    std::array<double, 4> start, end;  ///< s p + q: p, q
  };
  std::vector<Ends> ends;
  std::vector<Placed> placed;
  std::vector<double> points;
};

PairwiseSearch::PairwiseSearch(const PolygonSet& P, const PolygonSet& Q)
    : impl_(std::make_unique<Impl>()) {
  const FloatEnvironment standard;
  const auto numbers = [](const MovingVertex<Vector2<Rational>>& v) {
    return std::array{to_double(v.p.x()), to_double(v.p.y()), to_double(v.q.x()),
                      to_double(v.q.y())};
  };
  const auto edges = reduced_convolution(P, Q);
  for (const RationalEdge& edge :
       moving_edges(edges, scalar_operand<Rational>(P, {}), scalar_operand<Rational>(Q, {}))) {
    impl_->ends.push_back({numbers(start_of(edge)), numbers(end_of(edge))});
  }
}

PairwiseSearch::~PairwiseSearch() = default;

std::size_t PairwiseSearch::run(const Rational& scale) {
  const FloatEnvironment standard;
  const double s = to_double(scale);
  auto& [ends, placed, points] = *impl_;
  placed.clear();
  points.clear();
  for (const auto& [start, end] : ends) {
    const double x0 = s * start[0] + start[2], y0 = s * start[1] + start[3];
    const double x1 = s * end[0] + end[2], y1 = s * end[1] + end[3];
    placed.push_back(
        {x0, y0, x1, y1, std::min(x0, x1), std::max(x0, x1), std::min(y0, y1), std::max(y0, y1)});
  }
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Placed& a = placed[i];
    for (std::size_t j = i + 1; j < placed.size(); ++j) {
      if (boxes_meet(a, placed[j])) meet(a, placed[j], points);
    }
  }
  return points.size() / 2;
}

struct ContactSearch::Impl {
  PolygonSet P, Q;
  std::vector<ConvolutionEdge> edges;
};

ContactSearch::ContactSearch(const PolygonSet& P, const PolygonSet& Q)
    : impl_(std::make_unique<Impl>(Impl{P, Q, reduced_convolution(P, Q)})) {}

ContactSearch::~ContactSearch() = default;

std::size_t ContactSearch::run(const Rational& scale) const {
  const FloatEnvironment standard;
  return on_exact_frame(scaled(impl_->P, scale), impl_->Q, [&](const auto& frame) -> std::size_t {
    using K = typename std::decay_t<decltype(frame)>::K;
    auto convolution = convolution_segments<K>(impl_->edges, frame.P, frame.Q);
    const auto representative = coincident_vertices(frame.kernel, convolution.vertices);
    for (IndexedSegment& s : convolution.segments) {
      s = {representative[s.from], representative[s.to]};
    }
    SegmentContacts<K> found(frame.kernel, convolution.vertices, convolution.segments);
    // A crossing counts as a contact for both of its segments.
    return found.contacts().size() - found.crossings().size();
  });
}

}  // namespace minkref::inline plane
