#include "reference/plane/critical/moments.hpp"

#include <algorithm>
#include <cmath>

#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

Rational Moments::exact(std::uint32_t moment) const {
  const std::int64_t event = source_[moment].event;
  if (event < 0) return extra_[static_cast<std::size_t>(-1 - event)];
  const PairEvent& e = events_.events[static_cast<std::size_t>(event)];
  return event_scale(PlainKernel<Rational>{}, edges_[e.a], edges_[e.b], e);
}

std::uint32_t Moments::add_events(std::size_t event) {
  approximate_.push_back(events_.events[event].approximate);
  source_.push_back({static_cast<std::int64_t>(event)});
  ++from_events_;
  return static_cast<std::uint32_t>(approximate_.size() - 1);
}

std::uint32_t Moments::add_scale(const Rational& scale) {
  const double value = to_double(scale);
  const double reach = 2 * std::abs(value) * filter_bound + 1e-300;
  const auto end = approximate_.begin() + static_cast<std::ptrdiff_t>(from_events_);
  auto at = std::lower_bound(approximate_.begin(), end, value - reach);
  for (; at != end && !(*at > value + reach); ++at) {
    const auto moment = static_cast<std::uint32_t>(at - approximate_.begin());
    if (exact(moment) == scale) return moment;
  }
  for (std::size_t i = 0; i < extra_.size(); ++i) {
    if (extra_[i] == scale) return static_cast<std::uint32_t>(from_events_ + i);
  }
  extra_.push_back(scale);
  approximate_.push_back(value);
  source_.push_back({-static_cast<std::int64_t>(extra_.size())});
  return static_cast<std::uint32_t>(approximate_.size() - 1);
}

}  // namespace minkref::inline plane
