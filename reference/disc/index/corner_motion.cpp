#include "reference/disc/index/corner_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/disc/index/corner_place.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {
namespace {

constexpr double sharp = 0x1p-48;        // of a number
constexpr double sharp_place = 0x1p-44;  // in the frame, whose size is about 1

bool is_sharp_number(const Interval& value) {
  const double most = std::max(std::abs(value.lower()), std::abs(value.upper()));
  return std::isfinite(most) && value.upper() - value.lower() <= sharp * most;
}

/// Evaluates a number with intervals of doubles, or with roots if intervals do not hold the number
/// well.
template <class Make>
double rounded_well(Make&& make) {
  try {
    const Interval value = make(Interval());
    if (is_sharp_number(value)) return approximate(value);
  } catch (const UndecidedSign&) {
  }
  return nearest_double(make(RootNumber()));
}

/// factor · √square.
RealNumber root_times(const Rational& factor, const Rational& square) {
  return {[factor, square](long bits) {
            return MpfrInterval(factor, bits) * sqrt(MpfrInterval(square, bits));
          },
          {}};
}

struct Unit {
  double x, y;
};

/// Takes nearest doubles if squares of doubles leave the range.
Unit unit_of(const Direction& way) {
  const double x = to_double(way.x), y = to_double(way.y), length = std::hypot(x, y);
  if (length > 0x1p-1000 && length < 0x1p1000) return {x / length, y / length};
  const Rational square = dot(way, way);
  return {nearest_double(root_times(way.x / square, square)),
          nearest_double(root_times(way.y / square, square))};
}

double error_of_rounding(const CornerMotion& motion) {
  return 0x1p-52 * (std::abs(motion.ax) + std::abs(motion.ay));
}

class Corner {
 public:
  Corner(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half)
      : diagram_(diagram), graph_(graph), half_(graph.halves[half]) {
    const bool is_rising = rises(half_);
    low_ = is_rising ? half_.from : half_.to;
    high_ = is_rising ? half_.to : half_.from;
  }

  CornerMotion motion(const Site& a, const Site& b) const {
    if (a.is_point && b.is_point) return between_points(a.point, b.point);
    if (a.is_point) return between_point_and_line(a.point, b);
    if (b.is_point) return between_point_and_line(b.point, a);
    return between_lines(a, b);
  }

  int side_of_end(const Point& from, const Direction& along) const {
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

 private:
  /// w = ρ - d/2 for points at the distance d: half a chord is √(ρ² - d²/4) = √(w (d + w)).
  CornerMotion between_points(const Point& p, const Point& q) const {
    const Direction way = from_to(p, q), across = turned(way);
    const Point middle = middle_of(p, q);
    const Rational square = dot(way, way);
    const double turn = side_of_end(middle, across);
    const auto [half, rest] = two_doubles(root_times(Rational(1, 2), square));
    const Unit unit = unit_of(across);
    CornerMotion motion;
    motion.ax = to_double(middle.x);
    motion.ay = to_double(middle.y);
    motion.r = half;
    motion.r_low = rest;
    motion.k0 = 2 * half;
    motion.k1 = 1;
    motion.cx = turn * unit.x;
    motion.cy = turn * unit.y;
    motion.error = error_of_rounding(motion);
    return motion;
  }
  /// With the distance g of the point from the line and w = ρ - g/2: across the line the corner has
  /// gone w from the middle between both, and along it √(2 g w).
  CornerMotion between_point_and_line(const Point& v, const Site& line) const {
    const Direction &normal = line.normal, along = turned(normal);
    const Rational square = line.squared_length(), height = height_over(v, line);
    const double turn = side_of_end(v, along);
    const auto [half, rest] = two_doubles(root_times(height / (2 * square), square));
    const Unit across = unit_of(normal), onwards = unit_of(along);
    const Rational part = height / (2 * square);
    CornerMotion motion;
    motion.ax = to_double(v.x - part * normal.x);
    motion.ay = to_double(v.y - part * normal.y);
    motion.r = half;
    motion.r_low = rest;
    motion.bx = across.x;
    motion.by = across.y;
    motion.k0 = 4 * half;
    motion.cx = turn * onwards.x;
    motion.cy = turn * onwards.y;
    motion.error = error_of_rounding(motion);
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
      motion.error = error_of_rounding(motion);
      return motion;
    }
    const DiagramEvent& event = diagram_.events[low_];
    const auto width = [](const Interval& value) { return value.upper() - value.lower(); };
    const Interval radius = sqrt(event.squared_radius);
    motion.ax = approximate(event.at.x);
    motion.ay = approximate(event.at.y);
    motion.r = approximate(radius);
    motion.error = std::max(width(event.at.x), width(event.at.y)) +
                   width(radius) * (std::abs(motion.bx) + std::abs(motion.by));
    if (motion.error <= sharp_place) return motion;
    const Equidistant<RootNumber> place =
        equidistant_places<RootNumber>(diagram_.curves, event.of)[event.branch];
    motion.ax = nearest_double(place.at.x);
    motion.ay = nearest_double(place.at.y);
    const auto [high, low] = two_doubles(root_of(place.squared_radius));
    motion.r = high;
    motion.r_low = low;
    motion.error = error_of_rounding(motion);
    return motion;
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

std::pair<Site, Site> sites_of(const DiagramEvents& diagram, const DiagramGraph& graph,
                               std::uint32_t half) {
  const DiagramHalf& own = graph.halves[half];
  return {Site::of(diagram.curves, own.feature),
          Site::of(diagram.curves, graph.halves[own.twin].feature)};
}

}  // namespace

CornerMotion corner_motion(const DiagramEvents& diagram, const DiagramGraph& graph,
                           std::uint32_t half) {
  const auto [a, b] = sites_of(diagram, graph, half);
  return Corner(diagram, graph, half).motion(a, b);
}

int side_of_end(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half,
                const Point& from, const Direction& along) {
  return Corner(diagram, graph, half).side_of_end(from, along);
}

RootPoint corner_at(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half,
                    const Rational& squared_radius) {
  const auto [a, b] = sites_of(diagram, graph, half);
  return corner_place<RootNumber>(a, b, RootNumber(squared_radius), [&](const auto&... way) {
    return side_of_end(diagram, graph, half, way...);
  });
}

JointMotion joint_motion(const Point& end, const Direction& normal) {
  const double x = to_double(end.x), y = to_double(end.y);
  const Unit out = unit_of(normal);
  return {x, y, out.x, out.y, 0x1p-51 * (std::abs(x) + std::abs(y))};
}

}  // namespace minkref::inline disc
