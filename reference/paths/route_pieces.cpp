#include <algorithm>
#include <limits>

#include "reference/paths/moving_pieces.hpp"
#include "reference/paths/routes.hpp"

namespace minkref::inline paths {
namespace {

/// Ranges in doubles, rounded to the outside.
std::vector<MovingPieces::Gap> gaps_of(const std::vector<ScaleRange>& ranges) {
  std::vector<MovingPieces::Gap> gaps;
  for (const ScaleRange& range : ranges) {
    gaps.push_back(
        {enclose(range.from.scale).lower,
         range.to ? enclose(range.to->scale).upper : std::numeric_limits<double>::infinity()});
  }
  return gaps;
}

}  // namespace

ScaleSet collisions_of_pieces(const PathProblem& problem, PathStatistics& statistics) {
  const bool strict = problem.rule == ContactRule::allowed;
  MovingPieces pieces(problem.robot, problem.obstacles, problem.path, strict);
  ScaleSet collisions;
  std::vector<MovingPieces::Gap> gaps = gaps_of(collisions.left_of(problem.window));
  pieces.each(gaps, false, [&](const MovingPieces::Triple& triple) {
    ++statistics.exact_triples;
    const auto found = pieces.scales(triple);
    if (!found) return;
    const ScaleCut from{found->from, strict || found->from == 0};
    std::optional<ScaleCut> to;
    if (found->to) to = ScaleCut{*found->to, !strict};
    collisions.add(from, to);
    gaps = gaps_of(collisions.left_of(problem.window));
  });
  statistics.pieces_of_part = pieces.robot().size();
  statistics.pieces_of_obstacles = pieces.obstacles().size();
  statistics.triples = pieces.triples();
  return collisions;
}

}  // namespace minkref::inline paths
