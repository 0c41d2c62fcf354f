#include "reference/disc/convolution/arc_nodes.hpp"

#include <type_traits>

namespace minkref::inline disc {
namespace {

Direction signed_copy(int sign, const Direction& d) { return {sign * d.x, sign * d.y}; }

RootNumber root_number(const Rational& value) { return value; }

/// √a and √b over one field: without a second root if one root is a multiple of the other.
std::pair<RootNumber, RootNumber> two_roots(const Rational& a, const Rational& b) {
  const RootNumber first = sqrt(root_number(a));
  const RootNumber ratio = sqrt(root_number(b / a));
  if (ratio.field()->roots() == 0) return {first, ratio * first};
  return {first, sqrt(root_number(b).in(first.field()))};
}

}  // namespace

ArcNodes::ArcNodes(const ArcCurves& curves) : curves_(curves) {
  for (const ArcJoint& each : curves.joints) joint(each.circle, each.normal);
}

std::uint32_t ArcNodes::add(const ArcNode& node, const Vector<Interval>& position) {
  nodes_.push_back(node);
  positions_.push_back(position);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t ArcNodes::joint(std::uint32_t circle, const Direction& normal) {
  const auto [at, is_new] = joint_nodes_.try_emplace({circle, {normal.x, normal.y}},
                                                     static_cast<std::uint32_t>(nodes_.size()));
  if (is_new) {
    const auto number = static_cast<std::uint32_t>(joints_.size());
    joints_.push_back({circle, normal});
    const ArcNode node{ArcNode::Kind::joint, 0, circle, number};
    add(node, place<Interval>(node));
  }
  return at->second;
}

template <class N>
Vector<N> ArcNodes::place_of_joint(const ArcJoint& joint) const {
  const Rational square = curves_.squared_radius / dot(joint.normal, joint.normal);
  return numbers<N>(curves_.carriers[joint.circle].centre) +
         sqrt(N(square)) * numbers<N>(joint.normal);
}

template <class N>
Vector<N> ArcNodes::place_of_lines(const ArcCarrier& a, const ArcCarrier& b) const {
  const auto at = [](const Vector<N>& m, const N& k, const Vector<N>& n, const N& l) {
    const N turn = cross(m, n);
    return Vector<N>{(k * n.y - l * m.y) / turn, (l * m.x - k * n.x) / turn};
  };
  if constexpr (std::is_same_v<N, Interval>) {
    return at(a.near_point, a.near_level + N(a.side) * a.near_reach, b.near_point,
              b.near_level + N(b.side) * b.near_reach);
  } else {
    const auto [reach, other] = two_roots(a.squared_reach, b.squared_reach);
    return at(numbers<N>(a.normal()), a.level + a.side * reach, numbers<N>(b.normal()),
              b.level + b.side * other);
  }
}

template <class N>
Vector<N> ArcNodes::place_on_line(const ArcCarrier& line, const ArcCarrier& circle, int way) const {
  const auto at = [way](const Vector<N>& centre, const Vector<N>& along, const Vector<N>& normal,
                        const N& height, const N& square, const N& squared_length) {
    const N root = sqrt(square);
    const Vector<N> y = height * normal + (N(way) * root) * along;
    return centre + Vector<N>{y.x / squared_length, y.y / squared_length};
  };
  const Rational above = line.level - dot(line.normal(), {circle.centre.x, circle.centre.y});
  if constexpr (std::is_same_v<N, Interval>) {
    const N g(above), height = g + N(line.side) * line.near_reach;
    const N square = line.side == 0 ? N(Rational(line.squared_reach - above * above))
                                    : -g * (g + N(2 * line.side) * line.near_reach);
    return at(circle.near_point, line.near_way, line.near_point, height, square,
              line.near_squared_length);
  } else {
    const N height = line.side == 0 ? N(above) : above + line.side * sqrt(N(line.squared_reach));
    return at(numbers<N>(circle.centre), numbers<N>(line.way), numbers<N>(line.normal()), height,
              N(line.squared_reach) - height * height, N(line.squared_length));
  }
}

template <class N>
Vector<N> ArcNodes::place_of_circles(const ArcCarrier& a, const ArcCarrier& b, int way) const {
  const Direction w = from_to(a.centre, b.centre);
  const Rational square = dot(w, w);
  const N root = sqrt(N(Rational(curves_.squared_radius / square - Rational(1, 4))));
  const Vector<N> across = numbers<N>(w);
  return numbers<N>(a.centre) + N(Rational(1, 2)) * across + (N(way) * root) * turned(across);
}

template <class N>
Vector<N> ArcNodes::place(const ArcNode& node) const {
  const ArcCarrier& a = curves_.carriers[node.a];
  switch (node.kind) {
    case ArcNode::Kind::joint:
      break;
    case ArcNode::Kind::lines:
      return place_of_lines<N>(a, curves_.carriers[node.b]);
    case ArcNode::Kind::line_and_circle:
      return place_on_line<N>(a, curves_.carriers[node.b], node.way);
    case ArcNode::Kind::circles:
      return place_of_circles<N>(a, curves_.carriers[node.b], node.way);
  }
  return place_of_joint<N>(joints_[node.b]);
}

template Vector<Interval> ArcNodes::place<Interval>(const ArcNode&) const;
template Vector<RootNumber> ArcNodes::place<RootNumber>(const ArcNode&) const;

const RootPoint& ArcNodes::exact(std::uint32_t k) const {
  const auto found = exact_.find(k);
  if (found != exact_.end()) return found->second;
  return exact_.emplace(k, place<RootNumber>(nodes_[k])).first->second;
}

CarrierCrossings ArcNodes::meet(std::uint32_t a, std::uint32_t b) const {
  const bool of_a = curves_.carriers[a].is_circle, of_b = curves_.carriers[b].is_circle;
  if (of_a && of_b) return meet_circles(a, b);
  if (!of_a && !of_b) return meet_lines(a, b);
  return of_a ? meet_line_and_circle(b, a) : meet_line_and_circle(a, b);
}

CarrierCrossings ArcNodes::meet_lines(std::uint32_t a, std::uint32_t b) const {
  if (curves_.carriers[a].way_number == curves_.carriers[b].way_number) return {};
  return {std::nullopt, {{ArcNode::Kind::lines, 0, a, b}}};
}

CarrierCrossings ArcNodes::meet_line_and_circle(std::uint32_t a, std::uint32_t b) const {
  const ArcCarrier &line = curves_.carriers[a], &circle = curves_.carriers[b];
  const CarrierCrossings two{
      std::nullopt,
      {{ArcNode::Kind::line_and_circle, -1, a, b}, {ArcNode::Kind::line_and_circle, 1, a, b}}};
  // The centre's height above the line, less or more than the radius.
  const Interval near = line.near_level - dot(line.near_point, circle.near_point) +
                        Interval(line.side) * line.near_reach;
  const std::optional<int> certain =
      certified_sign(line.near_reach * line.near_reach - near * near);
  if (certain == 1) return two;
  if (certain == -1) return {};
  const Rational above = line.level - dot(line.normal(), {circle.centre.x, circle.centre.y});
  const int side = above.sign();
  if (line.side == 0) {
    const int found = Rational(line.squared_reach - above * above).sign();
    if (found > 0) return two;
    if (found < 0) return {};
    const Direction normal = signed_copy(side, line.normal());
    return {CarrierCrossings::Touch{normal, normal}, {}};
  }
  // -above (above + 2 side ρ |N|); the second factor is not rational.
  if (side == 0) {
    const Direction normal = signed_copy(line.side, line.normal());
    return {CarrierCrossings::Touch{normal, normal}, {}};
  }
  if (side == line.side || above * above > 4 * line.squared_reach) return {};
  return two;
}

CarrierCrossings ArcNodes::meet_circles(std::uint32_t a, std::uint32_t b) const {
  const CarrierCrossings two{
      std::nullopt, {{ArcNode::Kind::circles, -1, a, b}, {ArcNode::Kind::circles, 1, a, b}}};
  const Point &p = curves_.carriers[a].centre, &q = curves_.carriers[b].centre;
  const Vector<Interval> across = curves_.carriers[b].near_point - curves_.carriers[a].near_point;
  const std::optional<int> certain =
      certified_sign(Interval(4) * Interval(curves_.squared_radius) - dot(across, across));
  if (certain == 1) return two;
  if (certain == -1) return {};
  const Direction w = from_to(p, q);
  const int found = Rational(4 * curves_.squared_radius - dot(w, w)).sign();
  if (found > 0) return two;
  if (found < 0) return {};
  const Direction way = primitive(w);
  return {CarrierCrossings::Touch{way, signed_copy(-1, way)}, {}};
}

bool ArcNodes::is_on(const RootPoint& x, std::uint32_t number) const {
  const ArcCarrier& carrier = curves_.carriers[number];
  if (carrier.is_circle) {
    const RootPoint y = x - numbers<RootNumber>(carrier.centre);
    return sign(dot(y, y) - curves_.squared_radius) == 0;
  }
  const RootNumber height = dot(numbers<RootNumber>(carrier.normal()), x) - carrier.level;
  return sign(height) == carrier.side &&
         (carrier.side == 0 || sign(height * height - carrier.squared_reach) == 0);
}

bool ArcNodes::is_at(const RootPoint& x, const ArcNode& node) const {
  if (!is_on(x, node.a)) return false;
  const ArcCarrier& a = curves_.carriers[node.a];
  if (node.kind == ArcNode::Kind::joint) {
    const RootPoint y = x - numbers<RootNumber>(a.centre),
                    normal = numbers<RootNumber>(joints_[node.b].normal);
    return sign(cross(normal, y)) == 0 && sign(dot(normal, y)) > 0;
  }
  if (!is_on(x, node.b)) return false;
  const ArcCarrier& b = curves_.carriers[node.b];
  if (node.kind == ArcNode::Kind::lines) return true;
  if (node.kind == ArcNode::Kind::line_and_circle) {
    return sign(dot(numbers<RootNumber>(a.way), x - numbers<RootNumber>(b.centre))) == node.way;
  }
  const RootPoint across = numbers<RootNumber>(from_to(a.centre, b.centre));
  return sign(cross(across, x - numbers<RootNumber>(a.centre))) == node.way;
}

bool ArcNodes::are_same(std::uint32_t a, std::uint32_t b) const {
  if (a == b) return true;
  const auto overlap = [](const Interval& x, const Interval& y) {
    return x.lower() <= y.upper() && y.lower() <= x.upper();
  };
  if (!overlap(positions_[a].x, positions_[b].x) || !overlap(positions_[a].y, positions_[b].y)) {
    return false;
  }
  // The node with fewer roots is put into the other's equations.
  return nodes_[a].kind <= nodes_[b].kind ? is_at(exact(a), nodes_[b]) : is_at(exact(b), nodes_[a]);
}

}  // namespace minkref::inline disc
