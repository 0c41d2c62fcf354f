// The three routes, as valid_scales calls them: the scales of the window that are not valid.
#pragma once

#include <functional>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline paths {

/// Operands are neither empty nor both without area; the path has a vertex; the window is one.
struct PathProblem {
  const PolygonSet& robot;
  const PolygonSet& obstacles;
  const std::vector<Point>& path;
  ContactRule rule;
  ScaleWindow window;
};

/// Throws BadInput: a window that is none, a path without vertices, both sets without area.
void refuse_bad_problem(const PolygonSet& robot, const PolygonSet& obstacles,
                        const std::vector<Point>& path, const ScaleWindow& window);

ScaleSet collisions_of_pieces(const PathProblem& problem, PathStatistics& statistics);
ScaleSet collisions_by_contacts(const PathProblem& problem, PathStatistics& statistics);
ScaleSet collisions_by_index(const PathProblem& problem, PathStatistics& statistics);

/// The contacts at the ends of the valid scales, by pairs of convex pieces, whichever route found
/// these. Sorted by scale; of the contacts of one end the first along the path. Exact.
std::vector<PathBound> bounds_of(const PathProblem& problem, const std::vector<ScaleRange>& valid);

/// The set -R, by a half-turn.
PolygonSet half_turned(const PolygonSet& set);

/// Decides the window scale by scale: at its ends, at each critical scale, and at one between any
/// two. Exact if between two critical scales nothing changes.
ScaleSet decided_at(std::vector<Rational> critical, const ScaleWindow& window,
                    const std::function<bool(const Rational&)>& collides);

}  // namespace minkref::inline paths
