#include "reference/motion/space/valid_scales.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/error.hpp"
#include "reference/motion/piece_collisions.hpp"
#include "reference/motion/routes.hpp"
#include "reference/motion/space/contact_scales.hpp"
#include "reference/motion/space/open_pieces.hpp"
#include "reference/motion/space/swept_pieces.hpp"
#include "reference/motion/space/touching_features.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

/// The part, the obstacles and a path, all non-empty.
struct SpaceProblem {
  const Polyhedron& part;
  const Polyhedron& obstacles;
  const std::vector<SpacePoint>& path;
  ContactRule rule;
  ScaleWindow window;

  bool is_strict() const { return rule == ContactRule::allowed; }
};

void refuse_too_many(std::size_t part, std::size_t obstacles, std::size_t vertices) {
  if (part * obstacles + vertices * (part + obstacles) <= most_pairs_on_a_path) return;
  throw LimitExceeded("too-many-pairs",
                      "the part has " + std::to_string(part) + " convex pieces, the obstacles " +
                          std::to_string(obstacles) + ", and the path " + std::to_string(vertices) +
                          " vertices: more pairs of them than the " +
                          std::to_string(most_pairs_on_a_path) + " that are looked at",
                      "split the path, or give simpler operands");
}

MovingSolids moving_solids(const SpaceProblem& problem) {
  std::vector<SolidPiece> part =
      open_pieces(half_turned(problem.part), problem.is_strict() && is_thin(problem.obstacles));
  std::vector<SolidPiece> obstacles =
      open_pieces(problem.obstacles, problem.is_strict() && is_thin(problem.part));
  refuse_too_many(part.size(), obstacles.size(), problem.path.size());
  return {std::move(part), std::move(obstacles), problem.path, problem.is_strict()};
}

ScaleSet collisions_by_contacts_in_space(const SpaceProblem& problem, PathStatistics& statistics) {
  SweptPieces swept(problem.part, problem.obstacles, problem.path, problem.rule);
  statistics.pieces_of_part = swept.pieces_of_robot();
  statistics.pieces_of_obstacles = swept.pieces_of_obstacles();
  return decided_at(contact_scales(problem.part, problem.obstacles, problem.path), problem.window,
                    [&](const Rational& scale) {
                      ++statistics.critical_scales;
                      return swept.collide(scale);
                    });
}

/// Maps a piece of -R to the piece of x + sR.
SolidPiece placed_piece(const SolidPiece& turned, const SpacePoint& x, const Rational& scale) {
  Polyhedron result{{}, turned.faces};
  for (const SpacePoint& p : turned.corners) result.vertices.push_back(x - scale * p);
  for (Face& face : result.faces) std::reverse(face.begin(), face.end());
  return SolidPiece(result);
}

/// The contact at a place where two pieces start or stop to collide.
SpacePathBound contact_of(const SpaceProblem& problem, const MovingSolids& pieces,
                          const CollisionEnd<SpacePoint>& end) {
  const auto& [scale, blocks, at, triple] = end;
  const SolidPiece part = placed_piece(pieces.part()[triple.part], at.point, scale);
  for (const SpacePoint& p : touching_points(part, pieces.obstacles()[triple.obstacle])) {
    const auto of_part = feature_at(problem.part, 1 / scale * (p - at.point));
    const auto of_obstacles = feature_at(problem.obstacles, p);
    if (of_part && of_obstacles) return {scale, blocks, at, *of_part, *of_obstacles, p};
  }
  throw std::logic_error("pieces do not touch where their collisions end");
}

bool contains_origin_in_plane(const Polyhedron& polygon) {
  const std::vector<SpacePoint>& v = polygon.vertices;
  const Face& face = polygon.faces[0];
  SpacePoint normal;
  for (std::size_t k = 2; k < face.size(); ++k) {
    normal = normal + cross(v[face[k - 1]] - v[face[0]], v[face[k]] - v[face[0]]);
  }
  if (dot(normal, v[face[0]]) != 0) return false;
  for (std::size_t k = 0; k < face.size(); ++k) {
    if (dot(normal, cross(v[face[k]], v[face[(k + 1) % face.size()]])) < 0) return false;
  }
  return true;
}

}  // namespace

SpaceValidScales valid_scales(const Polyhedron& part, const Polyhedron& obstacles,
                              const std::vector<SpacePoint>& path, ContactRule rule,
                              const ScaleWindow& window, PathRoute route) {
  const FloatEnvironment standard;
  refuse_bad_window(window);
  if (path.empty()) {
    throw BadInput("bad-path", "a path has at least one vertex", "give it one");
  }
  if (route == PathRoute::index) {
    throw BadInput("no-route", "the route index is of paths in the plane",
                   "choose pieces or contacts");
  }
  if (part.empty() || obstacles.empty()) {
    SpaceValidScales result;
    result.valid = ScaleSet().left_of(window);
    return result;
  }
  if (is_thin(part) && is_thin(obstacles)) {
    throw BadInput("degenerate-operands", "both the part and the obstacles are without volume",
                   "only one of them may be a point, a segment or a plane polygon");
  }
  const SpaceProblem problem{part, obstacles, path, rule, window};
  const MovingSolids pieces = moving_solids(problem);
  SpaceValidScales result;
  const ScaleSet collisions = route == PathRoute::pieces
                                  ? collisions_of(pieces, window, result.statistics)
                                  : collisions_by_contacts_in_space(problem, result.statistics);
  result.valid = collisions.left_of(window);
  for (const auto& end : ends_of_collisions(pieces, window, result.valid)) {
    result.bounds.push_back(contact_of(problem, pieces, end));
  }
  return result;
}

std::vector<SpacePathBound> stops_of(const Polyhedron& part, const Polyhedron& obstacles,
                                     const std::vector<SpacePoint>& path, ContactRule rule,
                                     const std::vector<Rational>& scales) {
  const SpaceProblem problem{part, obstacles, path, rule, {}};
  const MovingSolids pieces = moving_solids(problem);
  std::vector<SpacePathBound> stops;
  for (const Rational& scale : scales) {
    stops.push_back(contact_of(problem, pieces, first_collision(pieces, scale)));
  }
  return stops;
}

bool star_shaped(const Polyhedron& part) {
  const FloatEnvironment standard;
  if (part.empty()) return true;
  if (part.is_point()) return is_zero(part.vertices[0]);
  if (part.is_segment()) {
    const SpacePoint &a = part.vertices[0], &b = part.vertices[1];
    return is_zero(cross(a, b)) && dot(a, b) <= 0;
  }
  if (part.faces.size() == 1) return contains_origin_in_plane(part);
  return std::all_of(part.faces.begin(), part.faces.end(), [&](const Face& face) {
    SpacePoint normal;
    const SpacePoint& first = part.vertices[face[0]];
    for (std::size_t k = 2; k < face.size(); ++k) {
      normal = normal + cross(part.vertices[face[k - 1]] - first, part.vertices[face[k]] - first);
    }
    return dot(normal, first) >= 0;
  });
}

}  // namespace minkref::inline space
