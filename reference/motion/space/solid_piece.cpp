#include "reference/motion/space/solid_piece.hpp"

#include <algorithm>
#include <map>

#include "reference/space/area_vector.hpp"

namespace minkref::inline space {
namespace {

SpacePoint rational_vector(const IntegerVector& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

SpacePoint opposite_vector(const SpacePoint& a) { return {-a.x, -a.y, -a.z}; }

NearVector<3> near_difference(const NearVector<3>& a, const NearVector<3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

NearVector<3> near_cross(const NearVector<3>& a, const NearVector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

using RoundedVector = std::array<double, 3>;

RoundedVector rounded_vector_of(const NearVector<3>& a) {
  return {approximate(a[0]), approximate(a[1]), approximate(a[2])};
}

double rounded_dot(const RoundedVector& a, const RoundedVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// An edge with the vectors that decide the directions of its farthest reach.
struct FarEdge {
  NearVector<3> near_along;
  std::vector<NearVector<3>> near_beside;

  FarEdge(const SolidPiece& piece, const SolidPiece::Edge& edge)
      : near_along(near_difference(piece.near_corners[edge.to], piece.near_corners[edge.from])) {
    for (const std::uint32_t c : edge.beside) {
      near_beside.push_back(near_difference(piece.near_corners[c], piece.near_corners[edge.from]));
    }
  }
};

std::vector<FarEdge> far_edges(const SolidPiece& piece) {
  std::vector<FarEdge> result;
  for (const SolidPiece::Edge& edge : piece.edges) result.emplace_back(piece, edge);
  return result;
}

/// The signs of n, plus or minus, for which the edge may be among the farthest.
struct FarSides {
  bool plus = true, minus = true;
  void look(const NearVector<3>& normal, const FarEdge& edge) {
    for (const NearVector<3>& way : edge.near_beside) {
      const Interval rise = product(normal, way);
      plus = plus && rise.lower() <= 0;
      minus = minus && rise.upper() >= 0;
    }
  }
  void look(const SpacePoint& normal, const SolidPiece& piece, const SolidPiece::Edge& edge) {
    for (const std::uint32_t c : edge.beside) {
      const Rational rise = dot(normal, piece.corners[c] - piece.corners[edge.from]);
      plus = plus && rise <= 0;
      minus = minus && rise >= 0;
    }
  }
  bool none() const { return !plus && !minus; }
};

}  // namespace

Polyhedron half_turned(const Polyhedron& part) {
  Polyhedron result = part;
  for (SpacePoint& v : result.vertices) v = opposite_vector(v);
  for (Face& face : result.faces) std::reverse(face.begin(), face.end());
  return result;
}

SolidPiece::SolidPiece(const Polyhedron& convex) : corners(convex.vertices), faces(convex.faces) {
  const IntegerPoints integers = integer_points(corners);
  for (const Face& face : faces) {
    across.push_back(rational_vector(primitive(area_vector(integers.points, face))));
  }
  if (faces.size() == 1) across.push_back(opposite_vector(across[0]));
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t from = face[k], to = face[(k + 1) % face.size()];
      const auto [at, fresh] =
          numbers.try_emplace(std::minmax(from, to), static_cast<std::uint32_t>(edges.size()));
      if (fresh) edges.push_back({from, to, {}});
      edges[at->second].beside.push_back(face[(k + 2) % face.size()]);
    }
  }
  if (faces.empty() && corners.size() == 2) edges.push_back({0, 1, {}});
  for (const SpacePoint& p : corners) {
    near_corners.push_back(PathsInSpace::near(p));
    SpaceBox one;
    for (std::size_t k = 0; k < 3; ++k) {
      one.low[k] = near_corners.back()[k].lower();
      one.high[k] = near_corners.back()[k].upper();
    }
    box.add(one);
  }
  for (const SpacePoint& p : across) near_across.push_back(PathsInSpace::near(p));
}

Rational SolidPiece::reach(const SpacePoint& direction) const {
  const NearVector<3> near = PathsInSpace::near(direction);
  std::vector<Interval> reaches;
  double least = -std::numeric_limits<double>::infinity();
  for (const NearVector<3>& corner : near_corners) {
    reaches.push_back(product(near, corner));
    least = std::max(least, reaches.back().lower());
  }
  std::optional<Rational> most;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (reaches[k].upper() < least) continue;
    Rational one = dot(direction, corners[k]);
    if (!most || one > *most) most = std::move(one);
  }
  return *most;
}

bool SolidPiece::contains(const SpacePoint& point) const {
  if (faces.empty()) {
    if (corners.size() == 1) return corners[0] == point;
    const SpacePoint to_first = corners[0] - point, to_second = corners[1] - point;
    return is_zero(cross(to_first, to_second)) && dot(to_first, to_second) <= 0;
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (dot(across[f], point - corners[faces[f][0]]) > 0) return false;
  }
  if (faces.size() > 1) return true;
  if (dot(across[0], point - corners[faces[0][0]]) < 0) return false;
  for (std::size_t k = 0; k < faces[0].size(); ++k) {
    const SpacePoint& from = corners[faces[0][k]];
    const SpacePoint along = corners[faces[0][(k + 1) % faces[0].size()]] - from;
    if (dot(cross(across[0], along), point - from) < 0) return false;
  }
  return true;
}

SpacePoint SolidPiece::middle() const {
  SpacePoint sum;
  for (const SpacePoint& p : corners) sum = sum + p;
  return Rational(1, corners.size()) * sum;
}

std::vector<NearVector<3>> PathsInSpace::across(const SpacePoint& from, const SpacePoint& to) {
  const SpacePoint along = to - from;
  std::vector<NearVector<3>> result;
  for (const SpacePoint& axis : {SpacePoint{1, 0, 0}, SpacePoint{0, 1, 0}, SpacePoint{0, 0, 1}}) {
    const SpacePoint n = cross(along, axis);
    if (is_zero(n)) continue;
    result.push_back(near(n));
    result.push_back(near(opposite_vector(n)));
  }
  return result;
}

std::vector<StripCondition> PathsInSpace::conditions(const SolidPiece& part,
                                                     const SolidPiece& obstacle,
                                                     const SpacePoint& from, const SpacePoint& to) {
  const SpacePoint along = to - from;
  std::vector<StripCondition> result;
  const auto add = [&](const SpacePoint& n, const Rational& of_robot, const Rational& of_obstacle) {
    result.push_back({dot(n, along), -of_robot, dot(n, from) - of_obstacle});
  };
  for (const SolidPiece* piece : {&obstacle, &part}) {
    for (const SpacePoint& n : piece->across) add(n, part.reach(n), obstacle.reach(n));
  }
  const std::vector<FarEdge> of_robot = far_edges(part), of_obstacle = far_edges(obstacle);
  for (std::size_t i = 0; i < of_robot.size(); ++i) {
    look_for_interrupt();
    for (std::size_t k = 0; k < of_obstacle.size(); ++k) {
      FarSides sides;
      const NearVector<3> near = near_cross(of_robot[i].near_along, of_obstacle[k].near_along);
      sides.look(near, of_robot[i]);
      sides.look(near, of_obstacle[k]);
      if (sides.none()) continue;
      const SolidPiece::Edge &a = part.edges[i], &b = obstacle.edges[k];
      const SpacePoint n = cross(part.corners[a.to] - part.corners[a.from],
                                 obstacle.corners[b.to] - obstacle.corners[b.from]);
      if (is_zero(n)) continue;
      sides.look(n, part, a);
      sides.look(n, obstacle, b);
      const Rational reach = dot(n, part.corners[a.from]);
      const Rational other = dot(n, obstacle.corners[b.from]);
      if (sides.plus) add(n, reach, other);
      if (sides.minus) add(opposite_vector(n), -reach, -other);
    }
  }
  return result;
}

bool PathsInSpace::apart(const SolidPiece& part, const SolidPiece& obstacle,
                         const NearVector<3>& from, const NearVector<3>& to, const ScaleGap& gap,
                         bool strict) {
  if (std::isinf(gap[1])) return false;
  const std::array<RoundedVector, 2> ends{rounded_vector_of(from), rounded_vector_of(to)};
  const auto farthest = [](const SolidPiece& piece, const RoundedVector& n) {
    RoundedVector best{};
    double most = -std::numeric_limits<double>::infinity();
    for (const NearVector<3>& corner : piece.near_corners) {
      const RoundedVector one = rounded_vector_of(corner);
      const double reach = rounded_dot(n, one);
      if (reach > most) {
        most = reach;
        best = one;
      }
    }
    return best;
  };
  // The least point along n of x - b - s a, with a, b in the pieces.
  const auto least = [&](const RoundedVector& n) {
    const bool first = rounded_dot(n, ends[0]) < rounded_dot(n, ends[1]);
    const RoundedVector &x = ends[first ? 0 : 1], b = farthest(obstacle, n), a = farthest(part, n);
    const double s = rounded_dot(n, a) > 0 ? gap[1] : gap[0];
    return RoundedVector{x[0] - b[0] - s * a[0], x[1] - b[1] - s * a[1], x[2] - b[2] - s * a[2]};
  };
  const auto proven = [&](const RoundedVector& n) {
    const NearVector<3> direction{Interval(n[0]), Interval(n[1]), Interval(n[2])};
    const double nearest =
        std::min(product(direction, from).lower(), product(direction, to).lower());
    const double room = room_across(nearest, reach_of(part.near_corners, direction),
                                    reach_of(obstacle.near_corners, direction), gap);
    return strict ? room >= 0 : room > 0;
  };
  constexpr int steps = 24;
  RoundedVector v = least({ends[0][0] - approximate(obstacle.near_corners[0][0]),
                           ends[0][1] - approximate(obstacle.near_corners[0][1]),
                           ends[0][2] - approximate(obstacle.near_corners[0][2])});
  for (int k = 0; k < steps; ++k) {
    const double size = rounded_dot(v, v);
    if (!(size > 0) || std::isinf(size)) return false;
    const RoundedVector w = least(v);
    const double height = rounded_dot(v, w);
    if (height > 0) return proven(v);
    const RoundedVector way{w[0] - v[0], w[1] - v[1], w[2] - v[2]};
    const double length = rounded_dot(way, way);
    if (!(length > 0)) return false;
    const double part = std::clamp(-rounded_dot(v, way) / length, 0.0, 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] += part * way[axis];
  }
  return false;
}

}  // namespace minkref::inline space

namespace minkref::inline motion {
template class MovingPiecesOf<PathsInSpace>;
}  // namespace minkref::inline motion
