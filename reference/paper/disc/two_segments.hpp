// "Intersections of line segments with line segments" (Behar & Lien 2012, Appendix).
#pragma once

#include <array>

#include "reference/paper/disc/meeting.hpp"

namespace minkref::inline disc {

/// Two segments that are not parallel: l1(t) = p1(s) + t d1 and l2(k) = p3(s) + k d2. Both t and k
/// are linear in s where the lines cross.
template <class T>
class TwoSegments {
 public:
  TwoSegments(const MovingFeature<T>& a, const MovingFeature<T>& b, const T& r)
      : features_{&a, &b}, r_(r) {
    const Vector<T> from = b.start[0] - a.start[0], by = r * (b.way[0] - a.way[0]);
    const T across = cross(a.along, b.along);
    at_one_ = {T(cross(from, b.along) / across), T(cross(from, a.along) / across)};
    slope_ = {T(cross(by, b.along) / across), T(cross(by, a.along) / across)};
    turn_ = sign(across);
  }

  Vector<T> place(const DiscScale<T>& at) const {
    const T t(at_one_[0] + T(at.s - T(1)) * slope_[0]);
    return features_[0]->end(0, at) + t * features_[0]->along;
  }

  std::optional<Meeting<T>> meeting(const AppendixReadings& readings) const {
    std::vector<detail::MeetingEvent<T>> events;
    for (const std::size_t own : {0U, 1U}) {
      for (const std::size_t end : {0U, 1U}) add(own, end, readings, events);
    }
    if (readings.number == Form::corrected) return detail::meeting_of(events, 0, true);
    return between_two(events);
  }

 private:
  /// Sets the crossing equal to an end: "rejecting solutions for which 0 < t or t > 1". The end's
  /// own parameter is 0 or 1.
  void add(std::size_t own, std::size_t end, const AppendixReadings& readings,
           std::vector<detail::MeetingEvent<T>>& events) const {
    if (sign(slope_[own]) == 0) return;
    const T scale(T(1) + T(T(static_cast<int>(end)) - at_one_[own]) / slope_[own]);
    if (sign(scale) <= 0) return;
    const std::size_t other = 1 - own;
    const T parameter(at_one_[other] + T(scale - T(1)) * slope_[other]);
    if (readings.rejected == Form::printed) {
      if (end == 1 || sign(parameter) > 0) return;
    } else if (sign(parameter) < 0 || sign(T(parameter - T(1))) > 0) {
      return;
    }
    const DiscScale<T> at{scale, r_};
    if (readings.solve == Form::printed &&
        !detail::are_equal(place(at), features_[own]->end(end, at))) {
      return;
    }
    events.push_back(
        {scale, 0, own == 0 ? (end == 0 ? turn_ : -turn_) : (end == 0 ? -turn_ : turn_)});
  }

  /// "they must have exactly two events".
  static std::optional<Meeting<T>> between_two(const std::vector<detail::MeetingEvent<T>>& events) {
    std::vector<T> scales;
    for (const auto& event : events) {
      detail::require_number(event.scale);
      bool is_new = true;
      for (const T& scale : scales) is_new = is_new && order_of(scale, event.scale) != 0;
      if (is_new) scales.push_back(event.scale);
    }
    if (scales.size() != 2) return std::nullopt;
    const bool ascends = order_of(scales[0], scales[1]) < 0;
    Meeting<T> found;
    found.lower = scales[ascends ? 0 : 1];
    found.upper = scales[ascends ? 1 : 0];
    return found;
  }

  std::array<const MovingFeature<T>*, 2> features_;
  const T& r_;
  std::array<T, 2> at_one_, slope_;  ///< t and k at s = 1, and their slopes
  int turn_ = 0;
};

/// Parallel segments that face each other may share a stretch at a single scale.
template <class T>
std::optional<Meeting<T>> parallel_meeting(const MovingFeature<T>& a, const MovingFeature<T>& b,
                                           const T& r) {
  if (sign(T(dot(a.way[0], b.way[0]))) >= 0) return std::nullopt;
  const T gap = dot(a.way[0], b.start[0] - a.start[0]);
  const T scale(T(1) + gap / T(T(2) * r));
  if (sign(scale) <= 0) return std::nullopt;
  const auto has_end = [](const MovingFeature<T>& of, const MovingFeature<T>& other) {
    return detail::is_on(of, other.corner[0]) || detail::is_on(of, other.corner[1]);
  };
  if (!has_end(a, b) && !has_end(b, a)) return std::nullopt;
  detail::require_number(scale);
  Meeting<T> found;
  found.is_overlap = true;
  found.lower = found.upper = scale;
  return found;
}

}  // namespace minkref::inline disc
