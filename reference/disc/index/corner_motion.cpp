#include "reference/disc/index/corner_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace minkref::inline disc {
namespace {

constexpr double sharp = 0x1p-46;        // of a number
constexpr double sharp_place = 0x1p-42;  // in the frame, whose size is about 1

bool is_sharp_number(const Interval& value) {
  const double most = std::max(std::abs(value.lower()), std::abs(value.upper()));
  return value.upper() - value.lower() <= sharp * most;
}

/// A number by intervals of doubles, or by roots where these do not hold it well.
template <class Make>
double rounded_well(Make&& make) {
  try {
    const Interval value = make(Interval());
    if (is_sharp_number(value)) return approximate(value);
  } catch (const UndecidedSign&) {
  }
  return approximate(tight(make(RootNumber())));
}

class Corner {
 public:
  Corner(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half)
      : diagram_(diagram), graph_(graph), half_(graph.halves[half]) {
    const bool is_rising = rises(half_);
    low_ = is_rising ? half_.from : half_.to;
    high_ = is_rising ? half_.to : half_.from;
  }

  CornerMotion between_points(const Point& p, const Point& q) const {
    const Direction way = from_to(p, q), across = turned(way);
    const Point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const Rational square = dot(way, way);
    const double turn = side_of_end(middle, across);
    CornerMotion motion;
    motion.ax = to_double(middle.x);
    motion.ay = to_double(middle.y);
    motion.q0 = -to_double(square / 4);
    motion.q2 = 1;
    const double length = std::sqrt(to_double(square));
    motion.cx = turn * to_double(across.x) / length;
    motion.cy = turn * to_double(across.y) / length;
    motion.error = 0x1p-52 * (std::abs(motion.ax) + std::abs(motion.ay));
    return motion;
  }

  CornerMotion between_point_and_line(const Point& v, const Site& line) const {
    const Direction &normal = line.normal, along = turned(normal);
    const Rational square = line.squared_length(),
                   height = normal.x * v.x + normal.y * v.y - line.level();
    const double length = std::sqrt(to_double(square)), turn = side_of_end(v, along);
    CornerMotion motion;
    motion.ax = to_double(v.x - height / square * normal.x);
    motion.ay = to_double(v.y - height / square * normal.y);
    motion.bx = to_double(normal.x) / length;
    motion.by = to_double(normal.y) / length;
    motion.q0 = -to_double(height * height / square);
    motion.q1 = 2 * to_double(height) / length;
    motion.cx = turn * to_double(along.x) / length;
    motion.cy = turn * to_double(along.y) / length;
    motion.error = 0x1p-52 * (std::abs(motion.ax) + std::abs(motion.ay));
    return motion;
  }

  CornerMotion between_lines(const Site& a, const Site& b) const {
    CornerMotion motion;
    if (cross(a.normal, b.normal) == 0) return motion;
    const auto speed = [&](const Rational& x, const Rational& y) {
      return rounded_well([&]<class N>(const N&) {
        const N square_a(a.squared_length()),
            length_a = sqrt(square_a), length_b = sqrt(joined(N(b.squared_length()), length_a));
        return (N(x) * length_b + N(y) * length_a) /
               (length_a * length_b + N(dot(a.normal, b.normal)));
      });
    };
    motion.bx = speed(a.normal.x, b.normal.x);
    motion.by = speed(a.normal.y, b.normal.y);
    if (graph_.is_reflex(low_)) {
      const Point at = reflex_vertex();
      motion.ax = to_double(at.x);
      motion.ay = to_double(at.y);
      motion.error = 0x1p-52 * (std::abs(motion.ax) + std::abs(motion.ay));
      return motion;
    }
    const DiagramEvent& event = diagram_.events[low_];
    Equidistant<Interval> place{event.at, event.squared_radius};
    const auto width = [](const Interval& value) { return value.upper() - value.lower(); };
    const auto error_of = [&] {
      const Interval radius = sqrt(place.squared_radius);
      return std::max(width(place.at.x), width(place.at.y)) +
             width(radius) * (std::abs(motion.bx) + std::abs(motion.by));
    };
    if (!(error_of() <= sharp_place)) {
      place = tight(equidistant_places<RootNumber>(diagram_.curves, event.of)[event.branch]);
    }
    motion.ax = approximate(place.at.x);
    motion.ay = approximate(place.at.y);
    motion.r = approximate(sqrt(place.squared_radius));
    motion.error = error_of();
    return motion;
  }

 private:
  /// Whether the farther end is on the left of a point, looked at against a vector: 1 or -1.
  double side_of_end(const Point& from, const Direction& along) const {
    if (graph_.is_infinite(high_)) {
      const HullGap& gap = diagram_.gaps[high_ - graph_.events];
      const auto& features = diagram_.curves.features;
      const Direction way = from_to(features[gap.from].centre, features[gap.to].centre);
      return sign(Rational(way.y * along.x - way.x * along.y));
    }
    const DiagramEvent& event = diagram_.events[high_];
    const auto by = [&]<class N>(const Vector<N>& at) {
      return dot(numbers<N>(along), at - numbers<N>(from));
    };
    if (const auto certain = certified_sign(by(event.at))) return *certain;
    return sign(by(equidistant_places<RootNumber>(diagram_.curves, event.of)[event.branch].at));
  }

  /// A half with a reflex vertex as its lower end.
  Point reflex_vertex() const {
    const auto& sides = diagram_.walks.sides;
    const std::uint32_t vertex =
        half_.from == low_ ? sides[half_.from_side].from : sides[half_.to_side].to;
    return diagram_.curves.features[vertex].centre;
  }

  bool rises(const DiagramHalf& half) const {
    if (graph_.is_reflex(half.from) || graph_.is_infinite(half.to)) return true;
    if (graph_.is_reflex(half.to) || graph_.is_infinite(half.from)) return false;
    return half.from < half.to;  // they are sorted by their radii
  }

  const DiagramEvents& diagram_;
  const DiagramGraph& graph_;
  const DiagramHalf& half_;
  std::uint32_t low_, high_;
};

}  // namespace

CornerMotion corner_motion(const DiagramEvents& diagram, const DiagramGraph& graph,
                           std::uint32_t half) {
  const DiagramHalf& own = graph.halves[half];
  const Corner corner(diagram, graph, half);
  const Site a = Site::of(diagram.curves, own.feature),
             b = Site::of(diagram.curves, graph.halves[own.twin].feature);
  if (a.is_point && b.is_point) return corner.between_points(a.point, b.point);
  if (a.is_point) return corner.between_point_and_line(a.point, b);
  if (b.is_point) return corner.between_point_and_line(b.point, a);
  return corner.between_lines(a, b);
}

JointMotion joint_motion(const Point& end, const Direction& normal) {
  const double length = std::sqrt(to_double(dot(normal, normal)));
  const double x = to_double(end.x), y = to_double(end.y);
  return {x, y, to_double(normal.x) / length, to_double(normal.y) / length,
          0x1p-51 * (std::abs(x) + std::abs(y))};
}

}  // namespace minkref::inline disc
