// The meetings of all pairs of the convolution's features (Behar & Lien 2012, Appendix).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/memory.hpp"
#include "reference/paper/disc/arc_and_segment.hpp"
#include "reference/paper/disc/curve_frame.hpp"
#include "reference/paper/disc/two_arcs.hpp"
#include "reference/paper/disc/two_segments.hpp"

namespace minkref::inline disc {

/// The features at one r, and the formulas of a pair, as read.
template <class T>
class PairFormulas {
 public:
  PairFormulas(const std::vector<MovingFeature<T>>& features, const T& r, bool is_unit,
               const AppendixReadings& readings)
      : features_(features), r_(r), is_unit_(is_unit), readings_(readings) {}

  /// Adds the meetings of two features. Throws UndecidedSign where a number is NaN.
  void add_meetings(std::uint32_t a, std::uint32_t b, std::vector<Meeting<T>>& found) const {
    const std::size_t before = found.size();
    const MovingFeature<T>&one = features_[a], &other = features_[b];
    if (one.is_arc && other.is_arc) {
      if (sign(T(other.centre().x - one.centre().x)) != 0 ||
          sign(T(other.centre().y - one.centre().y)) != 0) {
        TwoArcs<T>(one, other, r_, is_unit_, readings_).add_meetings(found);
      }
    } else if (one.is_arc || other.is_arc) {
      ArcAndSegment<T>(one.is_arc ? one : other, one.is_arc ? other : one, r_, readings_)
          .add_meetings(found);
    } else if (auto meeting = of_segments(one, other)) {
      found.push_back(*meeting);
    }
    for (std::size_t k = before; k < found.size(); ++k) {
      found[k].a = a;
      found[k].b = b;
    }
  }

  /// Where a meeting's point is; not for an overlap.
  Vector<T> place(const Meeting<T>& meeting, const DiscScale<T>& at) const {
    const MovingFeature<T>&one = features_[meeting.a], &other = features_[meeting.b];
    if (one.is_arc && other.is_arc) {
      return TwoArcs<T>(one, other, r_, is_unit_, readings_).place(at, meeting.branch);
    }
    if (!one.is_arc && !other.is_arc) return TwoSegments<T>(one, other, r_).place(at);
    return ArcAndSegment<T>(one.is_arc ? one : other, one.is_arc ? other : one, r_, readings_)
        .place(at, meeting.branch);
  }

 private:
  std::optional<Meeting<T>> of_segments(const MovingFeature<T>& a,
                                        const MovingFeature<T>& b) const {
    if (sign(T(cross(a.along, b.along))) != 0) return TwoSegments<T>(a, b, r_).meeting(readings_);
    return readings_.parallel ? parallel_meeting(a, b, r_) : std::nullopt;
  }

  const std::vector<MovingFeature<T>>& features_;
  const T& r_;
  bool is_unit_;
  const AppendixReadings& readings_;
};

template <class T>
struct MeetingList {
  std::vector<Meeting<T>> meetings;  ///< by a, then by b
  std::uint64_t pairs = 0;           ///< that were looked at
  std::uint64_t undecided = 0;       ///< that were left out: a number was NaN
};

/// The meetings of all pairs. Throws LimitExceeded beyond `memory` bytes (0: no limit). O(N^2).
template <class T>
MeetingList<T> find_meetings(const CurveFrame& frame, const PairFormulas<T>& formulas,
                             std::uint64_t memory) {
  MeetingList<T> all;
  const auto count = static_cast<std::uint32_t>(frame.features.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    look_for_interrupt_now();
    if (memory != 0) check_memory(memory, "the list of meetings");
    for (std::uint32_t b = a + 1; b < count; ++b) {
      if (frame.are_joined(a, b)) continue;
      ++all.pairs;
      const std::size_t before = all.meetings.size();
      try {
        formulas.add_meetings(a, b, all.meetings);
      } catch (const UndecidedSign&) {
        all.meetings.resize(before);
        ++all.undecided;
      }
    }
  }
  return all;
}

}  // namespace minkref::inline disc
