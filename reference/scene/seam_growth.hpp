// Seams that close while all copies grow about their places, beside a robot without area.
#pragma once

#include <optional>
#include <vector>

#include "reference/motion/valid_scales.hpp"
#include "reference/scene/scene.hpp"

namespace minkref::inline scene {

/// Copies that stop the robot together, and none of them alone.
struct Seam {
  Rational factor;
  bool at = false;                    ///< at the factor itself; else just above it
  std::vector<std::uint32_t> copies;  ///< those that touch there, ascending
  PathPlace place;                    ///< the robot's, on the way
  Point touching;                     ///< inside the union of the copies
};

/// Finds the first factor in [1, to] at which, or just above which, copies together stop a robot
/// that is a point or a segment and may touch them. The way must be free of each copy alone up to
/// `to` (none: always), and free of seams at 1. `near`: the copies that may touch it up to there.
/// Exact: between consecutive factors at which a vertex comes to the way, or an end of the way to
/// an edge, or vertices on the way meet, nothing changes. O(n) for each such factor, n the edges of
/// the near copies.
std::optional<Seam> first_seam(const Scene& scene, const std::vector<std::uint32_t>& near,
                               const std::vector<Point>& path, const std::optional<Rational>& to);

}  // namespace minkref::inline scene
