#include "reference/motion/path_diagram.hpp"

#include <algorithm>
#include <tuple>

#include "reference/error.hpp"
#include "reference/motion/moving_pieces.hpp"
#include "reference/motion/routes.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline motion {
namespace {

void refuse_endless(const ScaleWindow& window) {
  if (window.to && (!window.from || *window.from < *window.to)) return;
  throw BadInput("bad-window", "a diagram has a least and a greatest scale, one below the other",
                 "give the greatest scale, above the least");
}

}  // namespace

PathDiagram path_diagram(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, ContactRule rule,
                         const ScaleWindow& window, std::size_t most) {
  const FloatEnvironment standard;
  refuse_bad_problem(part, obstacles, path, window);
  refuse_endless(window);
  PathDiagram result;
  if (part.empty() || obstacles.empty()) return result;
  const MovingPieces pieces(part, obstacles, path, rule == ContactRule::allowed);
  const Rational from = window.from ? *window.from : Rational(0);
  const std::vector<MovingPieces::Gap> gaps{{enclose(from).lower, enclose(*window.to).upper}};
  pieces.each(gaps, false, [&](const MovingPieces::Triple& triple) {
    auto polygon = pieces.polygon(triple, from, *window.to);
    if (!polygon) return;
    if (result.polygons.size() == most) {
      throw LimitExceeded("limit",
                          "the diagram has more than " + std::to_string(most) + " polygons",
                          "choose a narrower window or a shorter path");
    }
    result.polygons.push_back(
        {triple.segment, triple.part, triple.obstacle, std::move(polygon->corners)});
  });
  std::sort(
      result.polygons.begin(), result.polygons.end(), [](const BadPolygon& a, const BadPolygon& b) {
        return std::tie(a.segment, a.part, a.obstacle) < std::tie(b.segment, b.part, b.obstacle);
      });
  for (const SidedPiece& piece : pieces.part()) {
    ConvexCorners& corners = result.part_pieces.emplace_back();
    for (const Point& p : piece.corners) corners.push_back({-p.x, -p.y});  // pieces belong to -R
  }
  for (const SidedPiece& piece : pieces.obstacles()) {
    result.obstacle_pieces.push_back(piece.corners);
  }
  return result;
}

}  // namespace minkref::inline motion
