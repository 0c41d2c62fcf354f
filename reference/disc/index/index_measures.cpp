#include "reference/disc/index/index_measures.hpp"

#include <utility>

#include "reference/disc/curves/angles.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

Interval magnitude(const Interval& value) {
  if (value.lower() >= 0) return value;
  if (value.upper() <= 0) return -value;
  return {0, std::max(-value.lower(), value.upper())};
}

Vector<Interval> near(const BoundedPoint& p) {
  return {Interval(p.x - p.error, p.x + p.error), Interval(p.y - p.error, p.y + p.error)};
}

Vector<Interval> unit_vector(const Vector<Interval>& a) {
  return (Interval(1) / sqrt(dot(a, a))) * a;
}

/// Halfway between the normals at the ends of an arc, of half a turn at most.
Vector<Interval> middle_between(const Direction& first, const Direction& last) {
  const Vector<Interval> from = unit_vector(numbers<Interval>(first)),
                         to = unit_vector(numbers<Interval>(last));
  const Vector<Interval> chord = to - from;
  // Across the chord, unless the chord is short.
  return dot(first, last) < 0 ? Vector<Interval>{chord.y, -chord.x} : from + to;
}

}  // namespace

IndexMeasures::IndexMeasures(const DiscIndex& index)
    : index_(index), middles_(index.diagram().curves.features.size()), area_(0) {
  const FloatEnvironment standard;
  const DiagramEvents& diagram = index.diagram();
  const OffsetCurves& curves = diagram.curves;
  Interval length(0), angle(0);
  for (const OffsetEdge& edge : curves.edges) {
    length += sqrt(Interval(edge.squared_length));
    area_ += cross(numbers<Interval>(edge.start), numbers<Interval>(edge.end)) / Interval(2);
  }
  for (const BoundarySide& side : diagram.walks.sides) {
    if (!side.is_arc) continue;
    const Direction &first = curves.edges[side.edge].normal, &last = curves.edges[side.next].normal;
    const Vector<Interval> middle = middle_between(first, last);
    middles_[side.feature] = middle;
    angle += angle_between(numbers<Interval>(first), middle) +
             angle_between(middle, numbers<Interval>(last));
  }
  if (curves.edges.empty() && !curves.patches.empty()) {  // a point
    const Vector<Interval> x{Interval(1), Interval(0)}, y{Interval(0), Interval(1)};
    angle = Interval(4) * angle_between(x, y);
  }
  for (const DiagramEvent& event : diagram.events) {
    Equidistant<Interval> place{event.at, event.squared_radius};
    const auto width = [](const Interval& value) { return value.upper() - value.lower(); };
    constexpr double sharp = 0x1p-40;
    if (width(place.at.x) + width(place.at.y) + width(place.squared_radius) > sharp) {
      place = tight(equidistant_places<RootNumber>(curves, event.of)[event.branch]);
    }
    places_.push_back({place.at, sqrt(place.squared_radius)});
  }
  const std::size_t gaps = index.radii() + 2;
  reached_.assign(gaps, Interval(0));
  lengths_.assign(gaps, Interval(0));
  angles_.assign(gaps, Interval(0));
  const DiagramGraph& graph = index.graph();
  for (std::uint32_t k = 0; k < graph.halves.size(); ++k) {
    const auto& [from, to] = ends_.emplace_back(seen_at_node(k, false), seen_at_node(k, true));
    const bool is_point = curves.features[graph.halves[k].feature].edge == OffsetPatch::none;
    (is_point ? angles_ : lengths_)[index.low(k)] += magnitude(to.along - from.along);
    if (index.high(k) <= index.radii()) reached_[index.high(k)] += area_between(k, from, to);
  }
  // Turns amounts at one radius into amounts up to each radius, and touched lengths and angles into
  // untouched ones.
  for (std::size_t k = 1; k < gaps; ++k) {
    reached_[k] += reached_[k - 1];
    lengths_[k] += lengths_[k - 1];
    angles_[k] += angles_[k - 1];
  }
  for (std::size_t k = 0; k < gaps; ++k) {
    lengths_[k] = length - lengths_[k];
    angles_[k] = angle - angles_[k];
  }
}

IndexMeasures::Seen IndexMeasures::seen(std::uint32_t half, const Vector<Interval>& at,
                                        const Interval& radius) const {
  const OffsetCurves& curves = index_.diagram().curves;
  const std::uint32_t feature = index_.graph().halves[half].feature;
  const OffsetCurves::Feature& own = curves.features[feature];
  if (own.edge == OffsetPatch::none) {
    return {angle_between(middles_[feature], at - numbers<Interval>(own.centre)), at, radius};
  }
  const OffsetEdge& edge = curves.edges[own.edge];
  const Interval along = dot(numbers<Interval>(edge.along), at - numbers<Interval>(edge.start)) /
                         sqrt(Interval(edge.squared_length));
  return {along, at, radius};
}

IndexMeasures::Seen IndexMeasures::seen_at_node(std::uint32_t half, bool at_end) const {
  const DiagramEvents& diagram = index_.diagram();
  const DiagramGraph& graph = index_.graph();
  const DiagramHalf& own = graph.halves[half];
  const std::uint32_t node = at_end ? own.to : own.from;
  if (graph.is_event(node)) {
    return seen(half, places_[node].at, places_[node].squared_radius);
  }
  const auto& features = diagram.curves.features;
  if (graph.is_infinite(node)) {
    const HullGap& gap = diagram.gaps[node - graph.events];
    const Direction way = from_to(features[gap.from].centre, features[gap.to].centre);
    const Vector<Interval> out = numbers<Interval>(Direction{way.y, -way.x});
    return {angle_between(middles_[own.feature], out), {}, Interval(0)};
  }
  const BoundarySide& side = diagram.walks.sides[at_end ? own.to_side : own.from_side];
  const Point& vertex = features[at_end ? side.to : side.from].centre;
  return seen(half, numbers<Interval>(vertex), Interval(0));
}

/// The area between the feature and the part of the diagram from one point to another: a trapezoid,
/// or one with a parabola on top; a triangle, or one with a parabola across.
Interval IndexMeasures::area_between(std::uint32_t half, const Seen& a, const Seen& b) const {
  const OffsetCurves& curves = index_.diagram().curves;
  const DiagramGraph& graph = index_.graph();
  const Site own = Site::of(curves, graph.halves[half].feature),
             other = Site::of(curves, graph.halves[graph.halves[half].twin].feature);
  if (own.is_point && other.is_point) {
    const Vector<Interval> v = numbers<Interval>(own.point);
    return magnitude(cross(a.at - v, b.at - v)) / Interval(2);
  }
  if (!own.is_point && !other.is_point) {
    return magnitude(b.along - a.along) * (a.radius + b.radius) / Interval(2);
  }
  const Site &line = own.is_point ? other : own, &point = own.is_point ? own : other;
  const Interval length = sqrt(Interval(line.squared_length()));
  const Vector<Interval> v = numbers<Interval>(point.point);
  const Interval height = Interval(Rational(line.normal.x * point.point.x +
                                            line.normal.y * point.point.y - line.level())) /
                          length;
  const auto foot = [&](const Seen& seen) {  // from that of the point
    return dot(turned(numbers<Interval>(line.normal)), seen.at - v) / length;
  };
  const auto sum = [&](const Interval& s) {
    const Interval cube = s * s * s / (Interval(3) * height);
    return own.is_point ? (cube + height * s) / Interval(4) : (cube + height * s) / Interval(2);
  };
  return magnitude(sum(foot(b)) - sum(foot(a)));
}

OffsetMeasures IndexMeasures::at(const DiscIndex::Place& at, const Rational& squared_radius) const {
  const FloatEnvironment standard;
  const DiagramGraph& graph = index_.graph();
  const OffsetCurves& curves = index_.diagram().curves;
  const FrameRadius radius = index_.in_frame(squared_radius);
  const Interval scale(index_.diagram().factor), rho = sqrt(Interval(radius.squared));
  Interval area = area_ + reached_[at.gap], length = lengths_[at.gap], angle = angles_[at.gap];
  for (std::uint32_t k = 0; k < graph.halves.size(); ++k) {
    if (index_.low(k) > at.gap || at.gap >= index_.high(k)) continue;
    const Seen corner = seen(k, near(index_.corner(k, radius)), rho);
    const auto& [from, to] = ends_[k];
    const bool is_rising = index_.rises(k);
    area += area_between(k, is_rising ? from : to, corner);
    const Interval free = magnitude((is_rising ? to : from).along - corner.along);
    const bool is_point = curves.features[graph.halves[k].feature].edge == OffsetPatch::none;
    (is_point ? angle : length) += free;
  }
  area += rho * length + rho * rho * angle / Interval(2);
  length += rho * angle;
  return {area / (scale * scale), length / scale};
}

}  // namespace minkref::inline disc
