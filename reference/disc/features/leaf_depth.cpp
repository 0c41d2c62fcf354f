#include "reference/disc/features/leaf_depth.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline disc {
LeafDepth::LeafDepth(const Bridges& bridges, const Point& vertex,
                     const std::vector<std::uint32_t>& halves, const BridgeRadius& radius)
    : bridges_(&bridges), halves_(&halves), vertex_(vertex), radius_(&radius) {
  const auto from = numbers<Interval>(vertex);
  for (const std::uint32_t half : halves) {
    look_for_interrupt();
    const auto [top, bottom] = squared_distance(from, bridges.chord<Interval>(half, radius));
    near_.push_back(top / bottom);
  }
}

Interval LeafDepth::near() const {
  if (is_zero()) return Interval(0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = infinity;
  for (const Interval& each : near_) {
    low = std::min(low, each.lower());
    high = std::min(high, each.upper());
  }
  return {std::max(low, 0.0), high};
}

template <class N>
SquaredDistance<N> LeafDepth::distance(std::size_t number) const {
  return squared_distance(numbers<N>(vertex_), bridges_->chord<N>((*halves_)[number], *radius_));
}

/// Between a line and a vertex: heights over the line, and the way along it, towards the corner.
/// Between two lines: heights over both, and the cosine of their angle. All as signed squares.
std::optional<LeafDepth::Shape> LeafDepth::shape(std::size_t number) const {
  const DiagramEvents& diagram = bridges_->index().diagram();
  const DiagramGraph& graph = bridges_->index().graph();
  const std::uint32_t half = (*halves_)[number];
  Site line = Site::of(diagram.curves, graph.halves[half].feature),
       other = Site::of(diagram.curves, graph.halves[graph.halves[half].twin].feature);
  if (line.is_point) std::swap(line, other);
  if (line.is_point) return std::nullopt;
  const auto signed_square = [](const Rational& value, const Rational& square) {
    return Rational(value * value * value.sign() / square);
  };
  const Rational length = line.squared_length(),
                 height = signed_square(height_over(vertex_, line), length);
  if (other.is_point) {
    const Direction along = turned(line.normal);
    const int side = side_of_end(diagram, graph, half, other.point, along);
    return Shape{0, height, signed_square(height_over(other.point, line), length),
                 side * signed_square(dot(along, from_to(other.point, vertex_)), length)};
  }
  const Rational second = signed_square(height_over(vertex_, other), other.squared_length());
  return Shape{1, std::min(height, second), std::max(height, second),
               signed_square(dot(line.normal, other.normal), length * other.squared_length())};
}

LeafDepth::Half LeafDepth::of_half(std::size_t number) const {
  try {
    const auto [top, bottom] = distance<RootNumber>(number);
    return {number, top / bottom};
  } catch (const LimitExceeded& error) {
    if (error.code() != "too-many-roots") throw;
    return {number, std::nullopt};
  }
}

int LeafDepth::order(const LeafDepth& a, const Half& x, const LeafDepth& b, const Half& y) {
  if (a.radius_ == b.radius_) {
    const auto first = a.shape(x.number);
    if (first && first == b.shape(y.number)) return 0;
  }
  if (x.exact && y.exact) return minkref::compare(*x.exact, *y.exact);
  const auto first = a.distance<Surd>(x.number), second = b.distance<Surd>(y.number);
  return sign(first.top * second.bottom - second.top * first.bottom);
}

const LeafDepth::Half& LeafDepth::nearest_half() const {
  if (nearest_) return *nearest_;
  const double high = near().upper();
  for (std::size_t k = 0; k < near_.size(); ++k) {
    if (near_[k].lower() > high) continue;
    Half half = of_half(k);
    if (!nearest_ || order(*this, half, *this, *nearest_) < 0) nearest_ = std::move(half);
  }
  return *nearest_;
}

int compare(const LeafDepth& a, const LeafDepth& b) {
  if (a.is_infinite() || b.is_infinite()) {
    return (a.is_infinite() ? 1 : 0) - (b.is_infinite() ? 1 : 0);
  }
  const Interval near_a = a.near(), near_b = b.near();
  if (near_a.upper() < near_b.lower()) return -1;
  if (near_b.upper() < near_a.lower()) return 1;
  if (a.is_zero() && b.is_zero()) return 0;
  look_for_interrupt_now();
  if (a.is_zero()) return -compare(b, a);
  if (b.is_zero()) {
    const auto distance = a.distance<Surd>(a.nearest_half().number);
    return sign(distance.top);
  }
  return LeafDepth::order(a, a.nearest_half(), b, b.nearest_half());
}

}  // namespace minkref::inline disc
