// The scales at which two moving edges meet, found without the event search.
#pragma once

#include <optional>

#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::fuzzing {

/// A closed interval of scales s > 0; without a bound it goes down to 0 or up to infinity.
struct MeetingScales {
  bool empty = true;
  std::optional<Rational> lower, upper;

  bool is_point() const { return lower && upper && *lower == *upper; }
  bool has_inside(const Rational& s) const {
    return !empty && (!lower || *lower < s) && (!upper || s < *upper);
  }
};

bool are_parallel(const RationalEdge& a, const RationalEdge& b);

/// The scales at which two edges, not parallel, meet: through their moving intersection and a scale
/// for each end point (the paper's way, corrected), in rational numbers.
MeetingScales meeting_scales(const RationalEdge& a, const RationalEdge& b);

/// Whether two closed edges have a point in common at a scale, by orientation signs alone.
bool do_meet(const RationalEdge& a, const RationalEdge& b, const Rational& s);

/// The positive scale at which the lines of three edges, no two parallel, share a point, if it is
/// unique.
std::optional<Rational> concurrent_scale(const RationalEdge& a, const RationalEdge& b,
                                         const RationalEdge& c);

}  // namespace minkref::fuzzing
