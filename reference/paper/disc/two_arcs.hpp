// "Intersections of arcs with arcs" (Behar & Lien 2012, Appendix).
#pragma once

#include <array>

#include "reference/paper/disc/meeting.hpp"

namespace minkref::inline disc {

/// Two arcs about different centres: from s0 on, their circles cross on both sides of the middle,
/// at distance M(s).
template <class T>
class TwoArcs {
 public:
  /// `is_unit`: r = 1.
  TwoArcs(const MovingFeature<T>& a, const MovingFeature<T>& b, const T& r, bool is_unit,
          const AppendixReadings& readings)
      : features_{&a, &b}, r_(r), readings_(readings), between_(b.centre() - a.centre()) {
    const T distance = root_of(T(dot(between_, between_)));
    ahead_ = {T(between_.x / distance), T(between_.y / distance)};
    first_ = T(distance / T(T(2) * r));
    middle_ = T(T(1) / T(2)) * (a.centre() + b.centre());
    is_right_ = readings.from_middle && !readings.with_height &&
                (readings.radical == Form::corrected || is_unit);
  }

  /// I(s) = M(s) (± ⊥ (c1, c2)), as read.
  Vector<T> place(const DiscScale<T>& at, int branch) const {
    const T square(at.s * at.s - first_ * first_);
    T out = readings_.radical == Form::corrected ? T(at.r * detail::root_or_zero(square))
                                                 : detail::root_or_zero(T(square * at.r));
    if (readings_.with_height) out = T(out + features_[0]->centre().y);
    const Vector<T> way = T(T(branch) * out) * turned(ahead_);
    return readings_.from_middle ? middle_ + way : way;
  }

  void add_meetings(std::vector<Meeting<T>>& found) const {
    std::vector<detail::MeetingEvent<T>> events;
    const Vector<T> back{T(-between_.x), T(-between_.y)};
    if (is_in_arc(*features_[0], between_) && is_in_arc(*features_[1], back)) {
      events.push_back({first_, 0, 0, true});
    }
    for (const std::size_t own : {0U, 1U}) {
      for (const std::size_t end : {0U, 1U}) add(own, end, events);
    }
    for (const int branch : {1, -1}) {
      if (auto meeting = detail::meeting_of(events, branch, false)) found.push_back(*meeting);
    }
  }

 private:
  /// Assigns I(s) to an end: along the line of the centres one equation, linear in s.
  void add(std::size_t own, std::size_t end, std::vector<detail::MeetingEvent<T>>& events) const {
    const MovingFeature<T>& feature = *features_[own];
    const Vector<T>& way = feature.way[end];
    const T slope(r_ * T(dot(way, ahead_)));
    if (sign(slope) == 0) return;
    const Vector<T> from = readings_.from_middle
                               ? middle_ - feature.centre()
                               : Vector<T>{T(-feature.centre().x), T(-feature.centre().y)};
    const T scale(T(dot(from, ahead_)) / slope);
    if (sign(scale) <= 0) return;
    const DiscScale<T> at{scale, r_};
    const Vector<T> x = feature.end(end, at);
    if (!detail::is_on(*features_[1 - own], x)) return;
    const int branch = sign(T(cross(ahead_, way)));
    if ((!is_right_ || readings_.solve == Form::printed) &&
        !detail::are_equal(place(at, branch), x)) {
      return;
    }
    events.push_back({scale, branch, (own == 0) == (end == 0) ? 1 : -1});
  }

  std::array<const MovingFeature<T>*, 2> features_;
  const T& r_;
  const AppendixReadings& readings_;
  Vector<T> between_, ahead_, middle_;
  T first_;  ///< s0
  bool is_right_ = false;
};

}  // namespace minkref::inline disc
