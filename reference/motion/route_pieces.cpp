#include <limits>

#include "reference/motion/moving_pieces.hpp"
#include "reference/motion/piece_collisions.hpp"
#include "reference/motion/routes.hpp"

namespace minkref::inline motion {

std::vector<ScaleGap> gaps_of(const std::vector<ScaleRange>& ranges) {
  std::vector<ScaleGap> gaps;
  for (const ScaleRange& range : ranges) {
    gaps.push_back(
        {enclose(range.from.scale).lower,
         range.to ? enclose(range.to->scale).upper : std::numeric_limits<double>::infinity()});
  }
  return gaps;
}

ScaleSet collisions_of_pieces(const PathProblem& problem, PathStatistics& statistics) {
  const MovingPieces pieces(problem.part, problem.obstacles, problem.path,
                            problem.rule == ContactRule::allowed);
  return collisions_of(pieces, problem.window, statistics);
}

}  // namespace minkref::inline motion
