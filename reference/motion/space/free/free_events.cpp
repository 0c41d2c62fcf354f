#include "reference/motion/space/free/free_events.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "reference/space/critical/critical_events.hpp"

namespace minkref::inline space {

FreeEvents::FreeEvents(const Polyhedron& turned, const Polyhedron& obstacles, const Rational& from,
                       const Rational& to)
    : events_(std::make_shared<const CriticalEvents>(
          critical_events_in_space(turned, obstacles, from, to, {}, EventsOf::all, {most}))) {
  for (const SpacePairEvent& one : events_->events) scales_.push_back(one.event.s.exact());
  for (const ConcurrentEvent& one : events_->concurrent) scales_.push_back(one.s.exact());
  std::sort(scales_.begin(), scales_.end());
  scales_.erase(std::unique(scales_.begin(), scales_.end()), scales_.end());
}

std::vector<SpacePoint> FreeEvents::places_at(const Rational& scale) const {
  const EventScale sought(scale);
  std::vector<SpacePoint> places;
  for (const SpacePairEvent& one : events_->events) {
    if (one.event.s != sought) continue;
    if (auto place = place_of(*events_, one)) places.push_back(*std::move(place));
  }
  for (const ConcurrentEvent& one : events_->concurrent) {
    if (one.s == sought) places.push_back(place_of(*events_, one));
  }
  const auto order = [](const SpacePoint& p) { return std::tie(p.x, p.y, p.z); };
  std::sort(places.begin(), places.end(),
            [&](const auto& a, const auto& b) { return order(a) < order(b); });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace minkref::inline space
