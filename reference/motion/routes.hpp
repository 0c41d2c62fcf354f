// The three routes, as valid_scales calls them: each returns the window's invalid scales.
#pragma once

#include <functional>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// Requires operands that are not empty and not both without area, a path with a vertex, and a
/// valid window.
struct PathProblem {
  const PolygonSet& part;
  const PolygonSet& obstacles;
  const std::vector<Point>& path;
  ContactRule rule;
  ScaleWindow window;
};

/// Throws BadInput: a window that is none, a path without vertices, both sets without area.
void refuse_bad_problem(const PolygonSet& part, const PolygonSet& obstacles,
                        const std::vector<Point>& path, const ScaleWindow& window);

ScaleSet collisions_of_pieces(const PathProblem& problem, PathStatistics& statistics);
ScaleSet collisions_by_contacts(const PathProblem& problem, PathStatistics& statistics);
ScaleSet collisions_by_index(const PathProblem& problem, PathStatistics& statistics);

/// The contacts at the ends of the valid scales, by pairs of convex pieces, whatever the route.
/// Sorted by scale; an end takes its first contact along the path. Exact.
std::vector<PathBound> bounds_of(const PathProblem& problem, const std::vector<ScaleRange>& valid);

/// The first place along the path where the part collides at each scale, or the limit of such
/// places, and the contact there. Requires a path valid at none of the scales, with its first place
/// free. Exact.
std::vector<PathBound> stops_of(const PathProblem& problem, const std::vector<Rational>& scales);

/// The set -R, by a half-turn.
PolygonSet half_turned(const PolygonSet& set);

/// Decides the window scale by scale: at its ends, at each critical scale, and at one between any
/// two. Exact if nothing changes between two critical scales.
ScaleSet decided_at(std::vector<Rational> critical, const ScaleWindow& window,
                    const std::function<bool(const Rational&)>& collides);

}  // namespace minkref::inline motion
