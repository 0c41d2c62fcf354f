#include "tests/fuzzing/reference/edge_meetings.hpp"

#include "reference/plane/critical/pair_interval.hpp"
#include "tests/plane/critical/segments_meet.hpp"

namespace minkref::fuzzing {
namespace {

using Vector = Vector2<Rational>;

}  // namespace

bool are_parallel(const RationalEdge& a, const RationalEdge& b) {
  return a.d.x() * b.d.y() == a.d.y() * b.d.x();
}

MeetingScales meeting_scales(const RationalEdge& a, const RationalEdge& b) {
  const auto range = corrected_interval<Rational>(end_conditions<Rational>(a, b));
  return {range.empty, range.lower, range.upper};
}

bool do_meet(const RationalEdge& a, const RationalEdge& b, const Rational& s) {
  const Vector a0 = at(start_of(a), s), a1 = at(end_of(a), s);
  const Vector b0 = at(start_of(b), s), b1 = at(end_of(b), s);
  return testing::do_segments_meet(a0, a1, b0, b1);
}

std::optional<Rational> concurrent_scale(const RationalEdge& a, const RationalEdge& b,
                                         const RationalEdge& c) {
  const auto cross = [](const Vector& u, const Vector& v) {
    return Rational(u.x() * v.y() - u.y() * v.x());
  };
  // The third line's distance from the other two lines' crossing: linear in s, so two scales
  // determine it.
  const auto offset = [&](const Rational& s) {
    const Vector a0 = at(start_of(a), s), b0 = at(start_of(b), s), c0 = at(start_of(c), s);
    const Vector point = a0 + a.d * Rational(cross(b0 - a0, b.d) / cross(a.d, b.d));
    return cross(c.d, point - c0);
  };
  const Rational at_one = offset(1), slope = offset(2) - at_one;
  if (sign(slope) == 0) return std::nullopt;
  const Rational s = 1 - at_one / slope;
  if (sign(s) <= 0) return std::nullopt;
  return s;
}

}  // namespace minkref::fuzzing
