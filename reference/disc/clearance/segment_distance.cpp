#include "reference/disc/clearance/segment_distance.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace minkref::inline disc {
namespace {

Point point_at(const ClosedSegment& segment, const Rational& t) {
  return {segment.a.x + t * (segment.b.x - segment.a.x),
          segment.a.y + t * (segment.b.y - segment.a.y)};
}

/// How far along a segment its nearest point to `p` is.
Rational foot(const ClosedSegment& segment, const Point& p) {
  const Direction along = from_to(segment.a, segment.b);
  const Rational squared = dot(along, along);
  if (squared == 0) return 0;
  return std::clamp(Rational(dot(along, from_to(segment.a, p)) / squared), Rational(0),
                    Rational(1));
}

Rational squared_between(const Point& a, const Point& b) {
  const Direction way = from_to(a, b);
  return dot(way, way);
}

/// Where two segments that are not parallel cross.
std::optional<NearestPlaces> crossing(const ClosedSegment& first, const ClosedSegment& second) {
  const Direction d = from_to(first.a, first.b), e = from_to(second.a, second.b),
                  w = from_to(first.a, second.a);
  const Rational turn = cross(d, e);
  if (turn == 0) return std::nullopt;
  const Rational t = cross(w, e) / turn, u = cross(w, d) / turn;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return NearestPlaces{0, t, u};
}

/// The least and the greatest that the smaller of two numbers may be.
Interval smaller(const Interval& a, const Interval& b) {
  return {std::min(a.lower(), b.lower()), std::min(a.upper(), b.upper())};
}

Interval squared(const Vector<Interval>& way) {
  const Interval sum = dot(way, way);
  return {std::max(sum.lower(), 0.0), sum.upper()};
}

Interval squared_distance(const NearSegment& segment, const Vector<Interval>& p) {
  const Vector<Interval> w = p - segment.a, v = p - segment.b;
  const Interval ends = smaller(squared(w), squared(v));
  const Interval foot = dot(segment.along, w);
  if (foot.upper() <= 0 || foot.lower() >= segment.squared_length.upper()) return ends;
  const Interval height = cross(segment.along, w), line = height * height / segment.squared_length;
  const double least = std::min(std::max(line.lower(), 0.0), ends.lower());
  const bool is_inside = foot.lower() >= 0 && foot.upper() <= segment.squared_length.lower();
  return {least, is_inside ? std::min(line.upper(), ends.upper()) : ends.upper()};
}

/// Whether both ends of a segment certainly lie on one side of the other's line.
bool is_beside(const NearSegment& line, const NearSegment& segment) {
  const auto a = certified_sign(cross(line.along, segment.a - line.a)),
             b = certified_sign(cross(line.along, segment.b - line.a));
  return a && b && *a * *b > 0;
}

}  // namespace

NearestPlaces nearest_places(const ClosedSegment& first, const ClosedSegment& second) {
  if (const auto found = crossing(first, second)) return *found;
  std::optional<NearestPlaces> best;
  const auto add = [&](const Rational& t, const Rational& u) {
    NearestPlaces one{squared_between(point_at(first, t), point_at(second, u)), t, u};
    if (!best || std::tie(one.squared, one.t, one.u) < std::tie(best->squared, best->t, best->u)) {
      best = std::move(one);
    }
  };
  add(0, foot(second, first.a));
  add(1, foot(second, first.b));
  add(foot(first, second.a), 0);
  add(foot(first, second.b), 1);
  if (first.a == first.b) best->t = 0;
  if (second.a == second.b) best->u = 0;
  return *best;
}

NearSegment::NearSegment(const ClosedSegment& segment)
    : a(numbers<Interval>(segment.a)),
      b(numbers<Interval>(segment.b)),
      along(numbers<Interval>(from_to(segment.a, segment.b))),
      squared_length(dot(along, along)) {}

Interval squared_distance(const NearSegment& first, const NearSegment& second) {
  const Interval ends =
      smaller(smaller(squared_distance(first, second.a), squared_distance(first, second.b)),
              smaller(squared_distance(second, first.a), squared_distance(second, first.b)));
  if (is_beside(first, second) || is_beside(second, first)) return ends;
  return {0, ends.upper()};
}

}  // namespace minkref::inline disc
