#include "reference/space/self_crossing.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/near/near_pairs.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/polyhedron_place.hpp"
#include "reference/space/triangle_contact.hpp"

namespace minkref::inline space {
namespace {

[[noreturn]] void refuse_contact(const SearchedSurface& surface, const SurfaceTriangle& first,
                                 const SurfaceTriangle& second, TriangleContact contact) {
  std::array<Rational, 3> common = common_point(first, second, surface.signs);
  for (Rational& c : common) c /= surface.denominator;
  const std::string at = "at " + short_text(SpacePoint{common[0], common[1], common[2]});
  const auto [face, other] = std::minmax(first.face, second.face);
  Place place = place_in(surface.polyhedron, face, {});
  place.other_face = other;
  if (contact == TriangleContact::crossing) {
    throw BadInput("self-intersection", "the surface passes through itself " + at,
                   "cut both faces where they meet and remove what is inside, or move one",
                   std::move(place));
  }
  throw BadInput("overlapping-faces", "two faces cover the same part of a plane " + at,
                 "remove that part of both, so that what is on its two sides is one, or move one",
                 std::move(place));
}

/// The vertices relative to the first vertex, measured with the unit of `signs`; equal vertices
/// share a number.
struct NearVertices {
  std::vector<NearPoint> points;
  std::vector<std::uint32_t> number;  ///< of each vertex
};

NearVertices near_vertices(const VertexSigns& signs) {
  const std::vector<IntegerVector>& points = signs.points();
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    return points[a] < points[b];
  });
  NearVertices result;
  result.number.resize(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    look_for_interrupt();
    const IntegerVector& p = points[order[k]];
    if (k == 0 || p != points[order[k - 1]]) {
      NearPoint& at = result.points.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] = signs.enclosed(p[axis] - points[0][axis]);
        at.low[axis] = low;
        at.width = std::max(at.width, high - low);
      }
    }
    result.number[order[k]] = static_cast<std::uint32_t>(result.points.size() - 1);
  }
  return result;
}

/// Boxes of slivers overlap far more often than slivers meet: so many pairs of boxes for each
/// triangle are looked at, and then only such pairs as clusters leave.
constexpr std::size_t most_pairs_by_boxes = 48;

}  // namespace

void refuse_crossing_faces(const SearchedSurface& surface) {
  const FloatEnvironment standard;
  const std::vector<SurfaceTriangle>& triangles = surface.triangles;
  const auto look_at = [&](std::uint32_t i, std::uint32_t j) {
    if (triangles[i].face == triangles[j].face) return;
    const TriangleContact contact = contact_of(triangles, surface.signs, i, j);
    if (contact != TriangleContact::none)
      refuse_contact(surface, triangles[i], triangles[j], contact);
  };
  std::size_t left = most_pairs_by_boxes * triangles.size();
  const bool are_left = surface.tree.pairs([&](std::uint32_t i, std::uint32_t j) {
    if (left == 0) return true;
    --left;
    look_at(i, j);
    return false;
  });
  if (!are_left) return;
  // Faces cross along segments, and cover each other on areas: never at a single point.
  auto [points, number] = near_vertices(surface.signs);
  std::vector<NearItem> items;
  items.reserve(triangles.size());
  for (const SurfaceTriangle& t : triangles) {
    items.push_back({{number[t.corners[0]], number[t.corners[1]], number[t.corners[2]]}, t.face});
  }
  NearPairs(std::move(points), std::move(items)).pairs(look_at);
}

}  // namespace minkref::inline space
