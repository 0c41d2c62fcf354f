#include "reference/motion/space/free/bounded_free_places.hpp"

#include <optional>
#include <stdexcept>

#include "reference/space/definition/definition_sum.hpp"
#include "reference/space/edges/edge_sum.hpp"
#include "reference/space/surface/shells.hpp"

namespace minkref::inline space {
namespace {

constexpr int most_rays = 1000;

/// The sum's surface, and its cavities' shells.
struct Cavities {
  SurfaceEdges surface;
  std::vector<Shell> shells;
};

Cavities cavities_of(const FreeProblemAt& problem) {
  const Scaling scaling{problem.scale, problem.scale, problem.scale};
  Cavities result{surface_edges(problem.route == FreeRoute::edges
                                    ? edge_sum(problem.turned, problem.obstacles, scaling).set
                                    : definition_sum(problem.turned, problem.obstacles, scaling)),
                  {}};
  for (Shell& shell : shells(result.surface, Pairing::outside)) {
    if (!shell.positive) result.shells.push_back(std::move(shell));
  }
  return result;
}

Rational product(const IntegerVector& normal, const SpacePoint& p) {
  return Rational(normal[0]) * p.x + Rational(normal[1]) * p.y + Rational(normal[2]) * p.z;
}

/// Whether the ray from a place along a direction crosses a face an odd number of times; none if
/// the direction is parallel to the face, or the ray meets an edge's line where it decides.
std::optional<bool> crosses(const SurfaceEdges& surface, const SurfaceFace& face,
                            const SpacePoint& place, const SpacePoint& direction) {
  const OrientedPlane& plane = surface.planes[face.plane];
  const Rational slope = product(plane.normal, direction);
  if (slope == 0) return std::nullopt;
  const Rational t = (plane.offset - product(plane.normal, place)) / slope;
  if (t <= 0) return false;  // a place off the surface is in no face
  const std::size_t axis = viewing_axis(plane.normal);
  const Point at =
      seen({place.x + t * direction.x, place.y + t * direction.y, place.z + t * direction.z}, axis);
  bool inside = false;
  for (const std::uint32_t first : face.walks) {
    for (const std::uint32_t h : surface.walk(first)) {
      const Point a = seen(surface.points[surface.half_edges[h].from].exact, axis);
      const Point b = seen(surface.points[surface.half_edges[h].to].exact, axis);
      if (a.y == at.y || b.y == at.y) return std::nullopt;
      if ((a.y < at.y) == (b.y < at.y)) continue;
      const Rational side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
      if (side == 0) return std::nullopt;
      inside = inside != ((side > 0) == (b.y > a.y));
    }
  }
  return inside;
}

/// Whether a shell surrounds a place; none if the ray is not generic.
std::optional<bool> is_around(const SurfaceEdges& surface, const Shell& shell,
                              const SpacePoint& place, const SpacePoint& direction) {
  bool inside = false;
  for (const std::uint32_t face : shell.faces) {
    const auto crossed = crosses(surface, surface.faces[face], place, direction);
    if (!crossed) return std::nullopt;
    inside = inside != *crossed;
  }
  return inside;
}

}  // namespace

bool has_bounded_free_places(const FreeProblemAt& problem) {
  return !cavities_of(problem).shells.empty();
}

bool is_enclosed(const FreeProblemAt& problem, const SpacePoint& place) {
  const Cavities cavities = cavities_of(problem);
  for (const Shell& shell : cavities.shells) {
    std::optional<bool> around;
    for (int k = 1; !around; ++k) {
      if (k == most_rays) throw std::logic_error("no ray in general position");
      // Directions on a curve within no plane: few run parallel to a face.
      const SpacePoint direction{1, Rational(k, 997), Rational(k * k, 99991)};
      around = is_around(cavities.surface, shell, place, direction);
    }
    if (*around) return true;
  }
  return false;
}

}  // namespace minkref::inline space
