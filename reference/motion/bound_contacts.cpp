#include <algorithm>
#include <tuple>

#include "reference/motion/moving_pieces.hpp"
#include "reference/motion/piece_collisions.hpp"
#include "reference/motion/routes.hpp"

namespace minkref::inline motion {
namespace {

Rational cross_of(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether a point lies on a closed segment.
bool on_segment(const Point& a, const Point& b, const Point& p) {
  if (cross_of(a, b, p) != 0) return false;
  return (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

bool holds_point(const ConvexCorners& piece, const Point& p) {
  const std::size_t n = piece.size();
  if (n == 1) return piece[0] == p;
  if (n == 2) return on_segment(piece[0], piece[1], p);
  for (std::size_t i = 0; i < n; ++i) {
    if (cross_of(piece[i], piece[(i + 1) % n], p) < 0) return false;
  }
  return true;
}

/// The vertex at a boundary point of a set, or the edge through the point.
std::optional<TouchingFeature> feature_at(const PolygonSet& set, const Point& p) {
  std::vector<const Ring*> rings;
  for (const Polygon& polygon : set.polygons) {
    rings.push_back(&polygon.outer);
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  }
  std::optional<TouchingFeature> edge;
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    for (std::uint32_t i = 0; i < ring.size(); ++i) {
      if (ring[i] == p) return TouchingFeature{false, {r, i}};
      if (!edge && on_segment(ring[i], ring[(i + 1) % ring.size()], p)) {
        edge = TouchingFeature{true, {r, i}};
      }
    }
  }
  return edge;
}

/// A contact of two pieces without a common area: a corner of either piece on the other.
struct TouchingPoint {
  Point at;
  TouchingFeature part, obstacle;
};
std::optional<TouchingPoint> touching(const PathProblem& problem, const ConvexCorners& part,
                                      const ConvexCorners& obstacle, const Point& x,
                                      const Rational& scale) {
  std::vector<Point> placed;  // pieces belong to -R
  for (const Point& p : part) placed.push_back({x.x - scale * p.x, x.y - scale * p.y});
  std::vector<Point> candidates;
  for (const Point& p : placed) {
    if (holds_point(obstacle, p)) candidates.push_back(p);
  }
  for (const Point& p : obstacle) {
    if (holds_point(placed, p)) candidates.push_back(p);
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Point& a, const Point& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
  for (const Point& p : candidates) {
    const auto part = feature_at(problem.part, {(p.x - x.x) / scale, (p.y - x.y) / scale});
    const auto other = feature_at(problem.obstacles, p);
    if (part && other) return TouchingPoint{p, *part, *other};
  }
  return std::nullopt;
}

}  // namespace

namespace {

/// The contact at a place where two pieces start or stop to collide.
PathBound contact_of(const PathProblem& problem, const MovingPieces& pieces,
                     const CollisionEnd<Point>& end) {
  const auto& [scale, blocks, at, triple] = end;
  const auto where = touching(problem, pieces.part()[triple.part].corners,
                              pieces.obstacles()[triple.obstacle].corners, at.point, scale);
  if (!where) throw std::logic_error("pieces do not touch where their collisions end");
  return {scale, blocks, at, where->part, where->obstacle, where->at};
}

MovingPieces pieces_of(const PathProblem& problem) {
  return {problem.part, problem.obstacles, problem.path, problem.rule == ContactRule::allowed};
}

}  // namespace

std::vector<PathBound> bounds_of(const PathProblem& problem, const std::vector<ScaleRange>& valid) {
  const MovingPieces pieces = pieces_of(problem);
  std::vector<PathBound> bounds;
  for (const auto& end : ends_of_collisions(pieces, problem.window, valid)) {
    bounds.push_back(contact_of(problem, pieces, end));
  }
  return bounds;
}

std::vector<PathBound> stops_of(const PathProblem& problem, const std::vector<Rational>& scales) {
  const MovingPieces pieces = pieces_of(problem);
  std::vector<PathBound> stops;
  for (const Rational& scale : scales) {
    stops.push_back(contact_of(problem, pieces, first_collision(pieces, scale)));
  }
  return stops;
}

}  // namespace minkref::inline motion
