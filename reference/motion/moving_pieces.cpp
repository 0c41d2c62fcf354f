#include "reference/motion/moving_pieces.hpp"

#include "reference/motion/routes.hpp"

namespace minkref::inline motion {
namespace {

std::vector<SidedPiece> sided(const std::vector<ConvexCorners>& pieces) {
  std::vector<SidedPiece> result;
  for (const ConvexCorners& piece : pieces) result.emplace_back(piece);
  return result;
}

}  // namespace

SidedPiece::SidedPiece(ConvexCorners corners_) : corners(std::move(corners_)) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n > 1 && i < n; ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % n];
    across.push_back({b.y - a.y, a.x - b.x});
  }
  for (const Point& p : corners) near_corners.push_back(PathsInThePlane::near(p));
  for (const Point& p : across) near_across.push_back(PathsInThePlane::near(p));
}

Rational SidedPiece::reach(const Point& direction) const {
  Rational most;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Rational one = direction.x * corners[i].x + direction.y * corners[i].y;
    if (i == 0 || one > most) most = std::move(one);
  }
  return most;
}

Point PathsInThePlane::point_at(const Point& from, const Point& to, const Rational& t) {
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
}

std::vector<NearVector<2>> PathsInThePlane::across(const Point& from, const Point& to) {
  return {near({to.y - from.y, from.x - to.x}), near({from.y - to.y, to.x - from.x})};
}

std::vector<StripCondition> PathsInThePlane::conditions(const SidedPiece& part,
                                                        const SidedPiece& obstacle,
                                                        const Point& from, const Point& to) {
  const Point along{to.x - from.x, to.y - from.y};
  std::vector<StripCondition> conditions;
  for (const SidedPiece* piece : {&obstacle, &part}) {
    for (const Point& n : piece->across) {
      conditions.push_back({n.x * along.x + n.y * along.y, -part.reach(n),
                            n.x * from.x + n.y * from.y - obstacle.reach(n)});
    }
  }
  return conditions;
}

template class MovingPiecesOf<PathsInThePlane>;

MovingPieces::MovingPieces(const PolygonSet& part, const PolygonSet& obstacles,
                           const std::vector<Point>& path, bool strict)
    : MovingPiecesOf(sided(open_pieces(half_turned(part), strict && !obstacles.is_region())),
                     sided(open_pieces(obstacles, strict && !part.is_region())), path, strict) {}

}  // namespace minkref::inline motion
