#include <algorithm>

#include "reference/motion/path_cuts.hpp"
#include "reference/motion/path_edges.hpp"
#include "reference/motion/routes.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline motion {
namespace {

/// Whether the path meets the sum at one scale. A single point stands for each stretch between two
/// contact edges, since nothing changes along the stretch.
bool meets_sum(const PathProblem& problem, const PolygonSet& turned,
               const std::vector<PathEdge>& edges, const Rational& scale) {
  const Membership sum(turned, problem.obstacles, scale);
  const bool allowed = problem.rule == ContactRule::allowed;
  const auto collides = [&](const Point& x) {
    const Contact contact = sum.contact(x);
    return allowed ? contact == Contact::overlapping : contact != Contact::empty;
  };
  // Most collisions show at once.
  if (std::any_of(problem.path.begin(), problem.path.end(), collides)) return true;
  std::vector<Segment> segments;
  segments.reserve(edges.size());
  for (const PathEdge& edge : edges) segments.push_back({edge.from.at(scale), edge.to.at(scale)});
  const PathCuts points = path_cuts(problem.path, segments);
  return std::any_of(points.between.begin(), points.between.end(), collides) ||
         std::any_of(points.cuts.begin(), points.cuts.end(), collides);
}

}  // namespace

ScaleSet collisions_by_contacts(const PathProblem& problem, PathStatistics& statistics) {
  const std::vector<PathEdge> edges = contact_edges(problem.part, problem.obstacles);
  std::vector<Rational> critical;
  for (const PathEdge& edge : edges) add_meeting_scales(edge, problem.path, critical);
  const PolygonSet turned = half_turned(problem.part);
  return decided_at(std::move(critical), problem.window, [&](const Rational& scale) {
    ++statistics.critical_scales;
    return meets_sum(problem, turned, edges, scale);
  });
}

}  // namespace minkref::inline motion
