#include "reference/space/triangle_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace minkref::inline space {
namespace {

constexpr std::size_t corner_after(std::size_t k) { return (k + 1) % 3; }

/// A triangle against another triangle's plane.
struct PlaneSides {
  std::array<int, 3> of;  ///< of its corners
  bool lies_in() const { return of[0] == 0 && of[1] == 0 && of[2] == 0; }
  /// The plane passes through the inside.
  bool cut() const {
    const auto [least, most] = std::minmax({of[0], of[1], of[2]});
    return least < 0 && most > 0;
  }
  /// The edge, named after its first corner, along which the triangle meets the plane, with the
  /// third corner off the plane.
  std::optional<std::size_t> edge() const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (of[k] == 0 && of[corner_after(k)] == 0 && of[corner_after(corner_after(k))] != 0)
        return k;
    }
    return std::nullopt;
  }
  /// The corner alone on its side, for a cut triangle.
  std::size_t alone() const {
    const int side = std::count(of.begin(), of.end(), 1) == 1 ? 1 : -1;
    return static_cast<std::size_t>(std::find(of.begin(), of.end(), side) - of.begin());
  }
};

/// Two triangles whose planes meet along a line or coincide.
class TrianglePair {
 public:
  TrianglePair(const std::vector<SurfaceTriangle>& triangles, const VertexSigns& signs,
               std::uint32_t first, std::uint32_t second)
      : triangles_(triangles), signs_(signs), numbers_{first, second} {}

  TriangleContact contact() const {
    const PlaneSides t = sides(1, 0);
    if (t.lies_in()) return overlap() ? TriangleContact::overlap : TriangleContact::none;
    if (!t.cut() && !t.edge()) return TriangleContact::none;
    const PlaneSides u = sides(0, 1);
    if (!u.cut() && !u.edge()) return TriangleContact::none;
    const bool crossing = t.cut() && u.cut() ? insides_meet(t, u)
                          : t.cut()          ? pierces(1, *u.edge(), 0)
                          : u.cut()          ? pierces(0, *t.edge(), 1)
                                             : edges_cross(*t.edge(), *u.edge());
    return crossing ? TriangleContact::crossing : TriangleContact::none;
  }

 private:
  const SurfaceTriangle& triangle(std::size_t which) const { return triangles_[numbers_[which]]; }
  std::uint32_t corner(std::size_t which, std::size_t k) const {
    return triangle(which).corners[k % 3];
  }

  int side_of(std::size_t plane, std::uint32_t vertex) const {
    return signs_.orientation(corner(plane, 0), corner(plane, 1), corner(plane, 2), vertex);
  }
  PlaneSides sides(std::size_t plane, std::size_t which) const {
    PlaneSides result{};
    for (std::size_t k = 0; k < 3; ++k) result.of[k] = side_of(plane, corner(which, k));
    return result;
  }

  /// An axis that shows a triangle faithfully, and the triangle's turn as seen.
  struct View {
    std::size_t axis;
    int turn;
  };
  View view(std::size_t which) const {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const int turn = signs_.turn(corner(which, 0), corner(which, 1), corner(which, 2), axis);
      if (turn != 0) return {axis, turn};
    }
    return {2, signs_.turn(corner(which, 0), corner(which, 1), corner(which, 2), 2)};
  }

  /// For coplanar triangles: convex sets lie apart iff some edge's line has the other set beyond
  /// it.
  bool overlap() const {
    const std::size_t axis = view(0).axis;
    for (std::size_t which = 0; which < 2; ++which) {
      const int own = signs_.turn(corner(which, 0), corner(which, 1), corner(which, 2), axis);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto beyond = [&](std::uint32_t v) {
          return own * signs_.turn(corner(which, k), corner(which, k + 1), v, axis) <= 0;
        };
        const TriangleCorners& other = triangle(1 - which).corners;
        if (std::all_of(other.begin(), other.end(), beyond)) return false;
      }
    }
    return true;
  }

  /// Both triangles meet their planes' common line along a segment, with ends on the two edges at
  /// the lone corner. With D the cross product of the normals, q the other end of such an edge from
  /// the corner p of the first triangle on the side s of the second, and q', p', s' likewise, det(q
  /// - p, p' - p, q' - p) has s s' times the sign of the way along D from the one point to the
  /// other. The later end of a segment is on the edge after the corner if the corner lies above, in
  /// the first triangle; in the second, on the edge before.
  bool insides_meet(const PlaneSides& t, const PlaneSides& u) const {
    const std::size_t p = t.alone(), q = u.alone();
    const int above = t.of[p], other = u.of[q];
    const std::size_t late = above > 0 ? p + 1 : p + 2, early = above > 0 ? p + 2 : p + 1;
    const std::size_t other_late = other > 0 ? q + 2 : q + 1,
                      other_early = other > 0 ? q + 1 : q + 2;
    const auto way = [&](std::size_t from, std::size_t to) {
      return above * other *
             signs_.orientation(corner(0, p), corner(0, from), corner(1, q), corner(1, to));
    };
    return way(early, other_late) > 0 && way(late, other_early) < 0;
  }

  /// Whether edge k of one triangle, which lies along the other triangle's plane, passes through
  /// the other triangle's inside, and the surface with the edge.
  bool pierces(std::size_t which, std::size_t k, std::size_t through) const {
    const std::uint32_t a = corner(which, k), b = corner(which, k + 1);
    const View seen = view(through);
    bool left = false, right = false;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t c = corner(through, j), d = corner(through, j + 1);
      const auto outside = [&](std::uint32_t v) {
        return seen.turn * signs_.turn(c, d, v, seen.axis) <= 0;
      };
      if (outside(a) && outside(b)) return false;
      const int turn = signs_.turn(a, b, c, seen.axis);
      left = left || turn > 0;
      right = right || turn < 0;
    }
    if (!left || !right) return false;
    return side_of(through, corner(which, k + 2)) * side_of(through, apex_beyond(which, k)) < 0;
  }

  /// The third corner of the triangle beyond an edge.
  std::uint32_t apex_beyond(std::size_t which, std::size_t k) const {
    const SurfaceTriangle& beyond = triangles_[triangle(which).beyond[k]];
    const auto on_edge = [&](std::uint32_t v) {
      return v == corner(which, k) || v == corner(which, k + 1);
    };
    return *std::find_if_not(beyond.corners.begin(), beyond.corners.end(), on_edge);
  }

  /// Both meet the line of their planes along an edge.
  bool edges_cross(std::size_t k, std::size_t j) const {
    if (triangle(0).beyond[k] == numbers_[1] && triangle(1).beyond[j] == numbers_[0]) return false;
    const std::uint32_t a = corner(0, k), b = corner(0, k + 1);
    if (!share_a_segment(a, b, corner(1, j), corner(1, j + 1))) return false;
    const std::uint32_t own = corner(0, k + 2), beyond = apex_beyond(0, k);
    const auto between = [&](std::uint32_t v) { return in_sector(a, b, own, beyond, v); };
    return between(corner(1, j + 2)) * between(apex_beyond(1, j)) < 0;
  }

  /// Whether two edges on one line share a segment.
  bool share_a_segment(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const std::vector<IntegerVector>& points = signs_.points();
    std::size_t axis = 0;
    while (points[a][axis] == points[b][axis]) ++axis;
    const auto [low, high] = std::minmax(points[a][axis], points[b][axis]);
    const auto [other_low, other_high] = std::minmax(points[c][axis], points[d][axis]);
    return low < other_high && other_low < high;
  }

  /// Around the line from a to b: 1 if v lies within the turn from `from` to `to`, -1 if v lies
  /// within the rest, 0 if v lies on either half-plane.
  int in_sector(std::uint32_t a, std::uint32_t b, std::uint32_t from, std::uint32_t to,
                std::uint32_t v) const {
    const int whole = signs_.orientation(a, b, from, to);
    const int after = signs_.orientation(a, b, from, v);
    if (whole == 0) return after;
    const int before = signs_.orientation(a, b, v, to);
    // The sector below a half-turn is that from `from` to `to`, or else that from `to` to `from`.
    const int least = std::min(whole * after, whole * before);
    const int most = std::max(whole * after, whole * before);
    if (least > 0) return whole;
    return least == 0 && most > 0 ? 0 : -whole;
  }

  const std::vector<SurfaceTriangle>& triangles_;
  const VertexSigns& signs_;
  std::array<std::uint32_t, 2> numbers_;
};

using ExactVector = std::array<Rational, 3>;

/// A convex polygon's part where a linear function is at least 0.
template <class Function>
std::vector<ExactVector> clipped(const std::vector<ExactVector>& polygon, Function&& value) {
  std::vector<ExactVector> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ExactVector &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const Rational at_p = value(p), at_q = value(q);
    if (at_p >= 0) result.push_back(p);
    if (at_p.sign() * at_q.sign() >= 0) continue;
    const Rational share = at_p / (at_p - at_q);
    ExactVector& cut = result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) cut[i] = p[i] + share * (q[i] - p[i]);
  }
  return result;
}

}  // namespace

TriangleContact contact_of(const std::vector<SurfaceTriangle>& triangles, const VertexSigns& signs,
                           std::uint32_t first, std::uint32_t second) {
  return TrianglePair(triangles, signs, first, second).contact();
}

std::array<Rational, 3> common_point(const SurfaceTriangle& first, const SurfaceTriangle& second,
                                     const VertexSigns& signs) {
  const auto point = [&](const SurfaceTriangle& t, std::size_t k) -> const IntegerVector& {
    return signs.points()[t.corners[k % 3]];
  };
  std::vector<ExactVector> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const IntegerVector& p = point(second, k);
    polygon.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
  }
  const IntegerVector normal =
      cross(point(first, 1) - point(first, 0), point(first, 2) - point(first, 0));
  const auto keep = [&](const IntegerVector& along, const IntegerVector& from) {
    polygon = clipped(polygon, [&](const ExactVector& x) {
      Rational value = 0;
      for (std::size_t i = 0; i < 3; ++i) value += Rational(along[i]) * (x[i] - Rational(from[i]));
      return value;
    });
  };
  keep(normal, point(first, 0));
  keep({-normal[0], -normal[1], -normal[2]}, point(first, 0));
  for (std::size_t k = 0; k < 3; ++k) {
    keep(cross(normal, point(first, k + 1) - point(first, k)), point(first, k));
  }
  ExactVector sum{0, 0, 0};
  for (const ExactVector& p : polygon) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i] / polygon.size();
  }
  return sum;
}

}  // namespace minkref::inline space
