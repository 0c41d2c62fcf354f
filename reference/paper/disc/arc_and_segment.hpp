// "Intersection of arcs with line segments" (Behar & Lien 2012, Appendix).
#pragma once

#include "reference/paper/disc/meeting.hpp"

namespace minkref::inline disc {

/// An arc whose centre lies at distance g before a segment's edge: from s0 = g / (2 r) on, the
/// circle crosses the segment's line on both sides of the centre's foot.
template <class T>
class ArcAndSegment {
 public:
  ArcAndSegment(const MovingFeature<T>& arc, const MovingFeature<T>& segment, const T& r,
                const AppendixReadings& readings)
      : arc_(arc), segment_(segment), r_(r), readings_(readings) {
    ahead_ = unit(segment.along);
    gap_ = T(r - T(dot(segment.way[0], segment.start[0] - arc.centre())));
    first_ = T(gap_ / T(T(2) * r));
  }

  /// As read: the foot moves with the line, or stays at x0 = xc - s0 r.
  Vector<T> place(const DiscScale<T>& at, int branch) const {
    const T radius(at.s * at.r);
    const bool stays = readings_.line == Form::printed;
    const T height = stays ? T(T(-first_) * at.r) : T(radius - gap_);
    const T out = stays ? T(at.r * detail::root_or_zero(T(at.s * at.s - first_ * first_)))
                        : detail::root_or_zero(T(gap_ * T(T(T(2) * radius) - gap_)));
    return arc_.centre() + height * segment_.way[0] + T(T(branch) * out) * ahead_;
  }

  /// Whether the circle meets the line, other than at all scales.
  bool is_met(const DiscScale<T>& at) const {
    return sign(gap_) > 0 && order_of(at.s, first_) >= 0;
  }

  void add_meetings(std::vector<Meeting<T>>& found) const {
    if (sign(gap_) <= 0) return;  // never met behind the line; always on the line
    std::vector<detail::MeetingEvent<T>> events;
    const Vector<T>& normal = segment_.way[0];
    const Vector<T> down{T(-normal.x), T(-normal.y)};
    if (is_in_arc(arc_, down) && detail::is_on(segment_, arc_.centre())) {
      events.push_back({first_, 0, 0, true});
    }
    for (const std::size_t end : {0U, 1U}) {
      add_end_of_segment(end, events);
      add_end_of_arc(end, events);
    }
    for (const int branch : {1, -1}) {
      if (auto meeting = detail::meeting_of(events, branch, false)) found.push_back(*meeting);
    }
  }

 private:
  void add_end_of_segment(std::size_t end, std::vector<detail::MeetingEvent<T>>& events) const {
    const T out = dot(segment_.corner[end] - arc_.centre(), ahead_);
    const bool stays = readings_.line == Form::printed;
    const T scale = stays ? first_ : T(T(out * out + gap_ * gap_) / T(T(T(2) * r_) * gap_));
    const DiscScale<T> at{scale, r_};
    const Vector<T> x = segment_.end(end, at);
    const int branch = sign(out);
    if (!detail::is_on(arc_, x)) return;
    if ((stays || readings_.solve == Form::printed) && !detail::are_equal(place(at, branch), x)) {
      return;
    }
    events.push_back({scale, branch, end == 0 ? 1 : -1});
  }

  void add_end_of_arc(std::size_t end, std::vector<detail::MeetingEvent<T>>& events) const {
    const T up = dot(segment_.way[0], arc_.way[end]);
    const bool stays = readings_.line == Form::printed;
    const T slope = stays ? T(-up) : T(T(1) - up);
    if (sign(slope) <= 0) return;
    const T scale = stays ? T(first_ / slope) : T(gap_ / T(r_ * slope));
    const DiscScale<T> at{scale, r_};
    const Vector<T> x = arc_.end(end, at);
    if (!detail::is_on(segment_, x)) return;
    const int branch = sign(T(dot(arc_.way[end], ahead_)));
    if (readings_.solve == Form::printed && !detail::are_equal(place(at, branch), x)) return;
    events.push_back({scale, branch, end == 0 ? -1 : 1});
  }

  const MovingFeature<T>&arc_, &segment_;
  const T& r_;
  const AppendixReadings& readings_;
  Vector<T> ahead_;
  T gap_, first_;
};

}  // namespace minkref::inline disc
