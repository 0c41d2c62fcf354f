#include "reference/disc/features/leaf_depth.hpp"

#include <algorithm>
#include <limits>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

int order(const SquaredDistance<Surd>& a, const SquaredDistance<Surd>& b) {
  return sign(a.top * b.bottom - b.top * a.bottom);
}

}  // namespace

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

SquaredDistance<Surd> LeafDepth::of_half(std::size_t k) const {
  return squared_distance(numbers<Surd>(vertex_), bridges_->chord<Surd>((*halves_)[k], *radius_));
}

const SquaredDistance<Surd>& LeafDepth::exact() const {
  if (!exact_ && is_zero()) exact_ = SquaredDistance<Surd>{Surd(0), Surd(1)};
  if (!exact_) exact_ = of_half(nearest_number());
  return *exact_;
}

std::size_t LeafDepth::nearest_number() const {
  const double high = near().upper();
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < near_.size(); ++k) {
    if (near_[k].lower() <= high) open.push_back(k);
  }
  std::size_t best = open.front();
  for (const std::size_t k : open) {
    if (k != best && order(of_half(k), of_half(best)) < 0) best = k;
  }
  return best;
}

std::uint32_t LeafDepth::nearest() const { return (*halves_)[nearest_number()]; }

int compare(const LeafDepth& a, const LeafDepth& b) {
  if (a.is_infinite() || b.is_infinite()) {
    return (a.is_infinite() ? 1 : 0) - (b.is_infinite() ? 1 : 0);
  }
  const Interval near_a = a.near(), near_b = b.near();
  if (near_a.upper() < near_b.lower()) return -1;
  if (near_b.upper() < near_a.lower()) return 1;
  if (a.is_zero() && b.is_zero()) return 0;
  return order(a.exact(), b.exact());
}

}  // namespace minkref::inline disc
